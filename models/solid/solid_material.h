/* solid_material.h - the law of solids; solid_element_material fills it. Fabrics are for
 * layers (solid_layer.h) alone: along the sheet they have matrices of their own for
 * stretches and for bends, across it the Young's modulus of their mean and half of it in
 * shear, which nobody measured, and no coupling between the two. */
#ifndef SOLID_MATERIAL_H
#define SOLID_MATERIAL_H

#include "models/law/law.h"

struct solid_material {
    double lambda, mu; /* Lame [Pa]                                                    */
    double plane;      /* lambda of plane stress, E nu / (1 - nu^2) [Pa]               */
    double across;     /* E - 2 mu [Pa]                                                */
    double density;    /* [kg/m^3]                                                     */
    bool is_fabric;
    double fabric[LAW_PARTS][LAW_ENTRIES]; /* along the sheet, over h and h^3 / 12 [Pa]  */
    double share[2]; /* parts of their own points in stretches along u and v [Pa]     */
};

#endif
