/* povray_run.h - povc under POV-Ray's command line. */
#ifndef CLI_POVRAY_RUN_H
#define CLI_POVRAY_RUN_H

/* Renders the frames of the command line, one by one. Returns POV-Ray's exit status: 0, or 1 after an error. */
int povray_run(int argc, char **argv);

#endif
