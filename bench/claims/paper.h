/* paper.h - the numbers printed in Ren, Dai, Lin 2024, Journal of Image and Graphics 29(1):
 * 243-255, to the digits printed. Nothing else in the program knows them. */
#ifndef PAPER_H
#define PAPER_H

/* Table 1: "RMSE <= 0.04" against the IGA result [m for a sheet of 1 m: the paper gives no
 * unit], where hexahedra come to it. Milliseconds, and Tables 2 and 3, stand in
 * the plans table1 to table3. */
#define PAPER_TABLE1_RMSE 0.04
#define PAPER_TABLE1_NET  "32x32x2"

/* Table 4, one end fixed, nu = 0.3: E as we read it (the paper has 1E-4, 5E-4, 1E-5), and
 * what it says of each. */
#define PAPER_LABEL_LIST(X)                                                                \
    X(OVER_STRETCHED, "over-stretched")                                                    \
    X(PENETRATION, "penetration")                                                          \
    X(TOO_LIGHT, "too light")                                                              \
    X(CHAOTIC, "chaotic")                                                                  \
    X(FINE_WRINKLES, "wrinkles too fine")

enum paper_label {
#define PAPER_LABEL_CODE(code, words) PAPER_##code,
    PAPER_LABEL_LIST(PAPER_LABEL_CODE)
#undef PAPER_LABEL_CODE
        PAPER_LABELS
};
extern const char *const paper_label[PAPER_LABELS];

struct paper_table4_row {
    double young, density, damping; /* [Pa], [kg/m^3], mu                              */
    unsigned labels;                /* bit n: label n; feasible where there is none    */
};
enum { PAPER_TABLE4_ROWS = 18 };
extern const struct paper_table4_row paper_table4[PAPER_TABLE4_ROWS];

#endif
