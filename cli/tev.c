#include "tev.h"
#include "save.h"

#include <netdb.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

/* A packet is its length, that number included, its kind, and what follows by kind; numbers are little-endian, texts end
 * with a zero. A new picture: focus, name, width, height, number and names of channels. An update: focus, name, number and
 * names of channels, x, y, width, height, offset and stride of each channel, in floats, and the pixels. */
enum { CREATE = 4, UPDATE = 6, CHANNELS = 3, PIXEL = 4, HEAD = 512, TILE = 64 };

typedef struct packet { unsigned char bytes[HEAD + PIXEL * sizeof(float) * TILE * TILE]; size_t count; } packet;

static void put_number(packet *p, uint64_t value, int bytes)
{
    for (int i = 0; i < bytes; i++)
        p->bytes[p->count++] = (unsigned char)(value >> (8 * i));
}

static void put_text(packet *p, const char *text)
{
    memcpy(p->bytes + p->count, text, strlen(text) + 1);
    p->count += strlen(text) + 1;
}

static void put_channels(packet *p)
{
    put_number(p, CHANNELS, 4);
    put_text(p, "R");
    put_text(p, "G");
    put_text(p, "B");
}

static void begin_packet(packet *p, int kind, const char *name)
{
    p->count = 4;
    put_number(p, (uint64_t)kind, 1);
    put_number(p, kind == CREATE, 1);   /* the focus */
    put_text(p, name);
}

static bool send_packet(tev *t, packet *p)
{
    const size_t count = p->count;
    size_t sent = 0;
    ssize_t now;

    p->count = 0;
    put_number(p, count, 4);
    while (sent < count) {
        now = send(t->socket, p->bytes + sent, count - sent, MSG_NOSIGNAL);
        if (now <= 0)
            return false;
        sent += (size_t)now;
    }
    return true;
}

/* ---- begin and end ---- */

static int connect_to(const char *host, const char *port)
{
    const struct addrinfo wanted = { .ai_socktype = SOCK_STREAM };
    struct addrinfo *found = NULL;
    int s = -1;

    if (getaddrinfo(host, port, &wanted, &found) != 0)
        return -1;
    for (const struct addrinfo *at = found; at && s < 0; at = at->ai_next) {
        s = socket(at->ai_family, at->ai_socktype, at->ai_protocol);
        if (s >= 0 && connect(s, at->ai_addr, at->ai_addrlen) != 0) {
            close(s);
            s = -1;
        }
    }
    freeaddrinfo(found);
    return s;
}

static bool create(tev *t, int width, int height)
{
    packet *p = malloc(sizeof *p);
    bool sent;

    if (!p)
        return false;
    begin_packet(p, CREATE, t->name);
    put_number(p, (uint64_t)width, 4);
    put_number(p, (uint64_t)height, 4);
    put_channels(p);
    sent = send_packet(t, p);
    free(p);
    return sent;
}

pov_status tev_begin(tev *t, const args *a, const messages *m, int width, int height, pov_error *err)
{
    const char *colon = a->tev ? strrchr(a->tev, ':') : NULL;
    char host[256];

    memset(t, 0, sizeof *t);
    t->messages = m;
    t->socket = -1;
    if (!colon)
        return POV_OK;
    snprintf(host, sizeof host, "%.*s", (int)(colon - a->tev), a->tev);
    snprintf(t->name, sizeof t->name, "%s", a->output);
    t->socket = connect_to(host, colon + 1);
    if (t->socket >= 0 && create(t, width, height))
        return POV_OK;
    tev_end(t);
    return save_fail(err, POV_E_IO, a->tev, "no viewer answers there; tev listens at 127.0.0.1:14158 unless told otherwise");
}

void tev_end(tev *t)
{
    if (t->socket >= 0)
        close(t->socket);
    t->socket = -1;
}

/* ---- tiles ---- */

static void put_pixels(packet *p, pov_job *job, pov_rect r)
{
    const size_t floats = (size_t)PIXEL * (size_t)r.width * (size_t)r.height;
    float *pixels = (float *)(void *)(p->bytes + HEAD);
    uint32_t bits;

    pov_job_read(job, r, POV_PIXELS_LINEAR_FLOAT, pixels, PIXEL * sizeof(float) * (size_t)r.width);
    for (size_t i = 0; i + 1 < floats; i++) {     /* without the last alpha, behind the last channel */
        memcpy(&bits, &pixels[i], sizeof bits);
        put_number(p, bits, 4);
    }
}

static bool send_tile(tev *t, packet *p, pov_job *job, pov_rect r)
{
    const int place[] = { r.x, r.y, r.width, r.height };

    begin_packet(p, UPDATE, t->name);
    put_channels(p);
    for (int i = 0; i < 4; i++)
        put_number(p, (uint64_t)place[i], 4);
    for (uint64_t i = 0; i < CHANNELS; i++)
        put_number(p, i, 8);
    for (int i = 0; i < CHANNELS; i++)
        put_number(p, PIXEL, 8);
    put_pixels(p, job, r);
    return send_packet(t, p);
}

void tev_send(tev *t, pov_job *job)
{
    packet *p = t->socket >= 0 ? malloc(sizeof *p) : NULL;
    pov_rect r;

    while (p && t->socket >= 0 && pov_job_take(job, &r))
        if (!send_tile(t, p, job, r)) {
            messages_say(t->messages, "the viewer is gone; the picture goes on without it");
            tev_end(t);
        }
    free(p);
}
