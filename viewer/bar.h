/* bar.h - the scales of maps: which colour a number has, and which numbers stand at a colour bar. */
#ifndef VIEWER_BAR_H
#define VIEWER_BAR_H

#include <stddef.h>
#include <stdint.h>

/* Kinds of bars, by the letter that stands for them in a panel's text. */
enum { BAR_RAMP = 'm', BAR_DEPTH = 'd', BAR_X = 'x', BAR_Y = 'y', BAR_Z = 'z' };

/* Numbers of which each step of ten is equally wide. */
typedef struct bar_scale { double low, high; } bar_scale;
extern const bar_scale bar_samples, bar_seconds, bar_error;

/* Position of a number on the bar; 0: its left end, 1: its right one, and beyond. */
double bar_share(const bar_scale *s, double value);
/* White near, black far: the right end of the bar is infinitely far, and `middle` is in its middle. */
double bar_depth_share(double middle, double depth);
/* Red, green, blue, alpha at a position. */
void bar_color(int kind, double share, uint8_t *rgba);

/* A line of a panel with the bar and its numbers: whole powers of ten, of which `unit` makes one the printed 1. */
void bar_write(const bar_scale *s, double unit, char *out, size_t size);
/* The same for depths: up to five round numbers, so far apart that they can be read. */
void bar_write_depth(double middle, char *out, size_t size);

#endif
