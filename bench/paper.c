#include "bench/paper.h"

/* clang-format off */
const struct paper_table1_row paper_table1[PAPER_TABLE1_ROWS] = {
    {"IGA-Galerkin", "iga",   {10, 10, 2}, 0.091},
    {"FEM",          "hex",   {32, 32, 2}, 16.048},
    {"shell IGA",    "shell", {10, 10, 0}, 0.130},
};

const struct paper_cost paper_cost[PAPER_COSTS] = {
    {50, 10}, {200, 82}, {450, 408}, {800, 1281},
};
/* clang-format on */
