/* solid_material.h - the isotropic law of solids; solid_element_material fills it. */
#ifndef SOLID_MATERIAL_H
#define SOLID_MATERIAL_H

#include "models/law/law.h"

struct solid_material {
    double lambda, mu; /* Lame [Pa]                                                    */
    double plane;      /* lambda of plane stress, E nu / (1 - nu^2) [Pa]               */
    double across;     /* E - 2 mu [Pa]                                                */
    double density;    /* [kg/m^3]                                                     */
};

#endif
