/* paper.h - the numbers printed in Ren, Dai, Lin 2024, Journal of Image and Graphics 29(1):
 * 243-255, to the digits printed. Nothing else in the program knows them. */
#ifndef PAPER_H
#define PAPER_H

/* Table 1: cost of a frame at comparable looks. */
struct paper_table1_row {
    const char *method; /* as printed, translated                                       */
    const char *model;  /* our key                                                      */
    int points[3];      /* points[2] = 0: a surface                                     */
    double seconds;     /* [s]                                                          */
};
enum { PAPER_TABLE1_ROWS = 3 };
extern const struct paper_table1_row paper_table1[PAPER_TABLE1_ROWS];

/* "RMSE <= 0.04" against the IGA result [m for a sheet of 1 m: the paper gives no unit]. */
#define PAPER_TABLE1_RMSE 0.04

/* Table 2, last column against control points: 82, 408, 1281 ms at 200, 450, 800. */
struct paper_cost {
    int control_points;
    double milliseconds;
};
enum { PAPER_COSTS = 4 };
extern const struct paper_cost paper_cost[PAPER_COSTS];

#endif
