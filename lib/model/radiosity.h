/* radiosity.h - what a scene says of light that diffuse surfaces send to each other. */
#ifndef MODEL_RADIOSITY_H
#define MODEL_RADIOSITY_H

#include <stdbool.h>
#include <stdint.h>

/* Without `given` surfaces have the light of light sources only. */
typedef struct radiosity_settings {
    bool given;
    uint32_t recursion_limit;    /* diffuse bounces between the camera's surface and the last one */
    uint32_t draws;              /* directions from a surface that the camera sees, a power of two */
    float brightness;            /* factor of every bounce */
    float gray_threshold;        /* share of each sample's colour that becomes grey */
    float max_sample;            /* a sample brighter than this is scaled down to it; 0: none is */
    double adc_bailout;          /* paths of a weight below it end */
    bool uses_normals;           /* perturbed normals count */
    bool sees_media;
} radiosity_settings;

#endif
