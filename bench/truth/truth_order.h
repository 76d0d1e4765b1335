/* truth_order.h - the order at which three runs approach a limit, and how far the finest
 * may still be from it (Roache, J. Fluids Eng. 116, 1994; Celik et al., same, 130, 2008).
 */
#ifndef TRUTH_ORDER_H
#define TRUTH_ORDER_H

struct truth_order {
    double order; /* observed [1]; NaN: the differences do not shrink                  */
    double bar;   /* of the finest run, in the unit of the differences                 */
};

/* From sizes h[0] > h[1] > h[2] > 0, the differences first = |x0 - x1| and second = |x1 -
 * x2|, both >= 0, and the order that theory promises. The bar is the difference that the
 * order leaves, times the usual factor of safety: 1.25. An order above the promised one is
 * not believed; one below 0.5, or none, counts as 0.5 with a factor of 3. Two equal runs:
 * 0. */
struct truth_order truth_order(const double h[3], double first, double second,
                               double promised);

#endif
