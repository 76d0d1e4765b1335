/* study_cast.h - contestants that more than one study of pictures shows, by their names. */
#ifndef STUDY_CAST_H
#define STUDY_CAST_H

#define STUDY_CAST_SHELL      "shell_2"
#define STUDY_CAST_SPRINGS    "mass_spring"
#define STUDY_CAST_PROJECTIVE "projective_dynamics"

#endif
