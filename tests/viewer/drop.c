/* Drops a file on the window under the pointer, as a file manager does: XDND version 5. Usage: drop WINDOW PATH. */
#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static Display *display;
static Window target, source;

static Atom named(const char *name)
{
    return XInternAtom(display, name, False);
}

static void tell(const char *what, long a, long b, long c, long d)
{
    XEvent e = { 0 };

    e.xclient.type = ClientMessage;
    e.xclient.window = target;
    e.xclient.message_type = named(what);
    e.xclient.format = 32;
    e.xclient.data.l[0] = (long)source;
    e.xclient.data.l[1] = a;
    e.xclient.data.l[2] = b;
    e.xclient.data.l[3] = c;
    e.xclient.data.l[4] = d;
    XSendEvent(display, target, False, NoEventMask, &e);
    XFlush(display);
}

static void answer(const XSelectionRequestEvent *r, const char *text)
{
    XEvent e = { 0 };

    XChangeProperty(display, r->requestor, r->property, r->target, 8, PropModeReplace, (const unsigned char *)text,
                    (int)strlen(text));
    e.xselection.type = SelectionNotify;
    e.xselection.requestor = r->requestor;
    e.xselection.selection = r->selection;
    e.xselection.target = r->target;
    e.xselection.property = r->property;
    e.xselection.time = r->time;
    XSendEvent(display, r->requestor, False, NoEventMask, &e);
    XFlush(display);
}

int main(int argc, char **argv)
{
    char text[600];
    XEvent e;

    display = XOpenDisplay(NULL);
    if (argc != 3 || !display)
        return 2;
    alarm(10);
    snprintf(text, sizeof text, "file://%s\r\n", argv[2]);
    target = (Window)strtoul(argv[1], NULL, 0);
    source = XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0);
    XSetSelectionOwner(display, named("XdndSelection"), source, CurrentTime);
    tell("XdndEnter", 5L << 24, (long)named("text/uri-list"), 0, 0);
    tell("XdndPosition", 0, 50L << 16 | 50, CurrentTime, (long)named("XdndActionCopy"));
    for (;;) {
        XNextEvent(display, &e);
        if (e.type == SelectionRequest)
            answer(&e.xselectionrequest, text);
        else if (e.type == ClientMessage && e.xclient.message_type == named("XdndStatus"))
            tell("XdndDrop", 0, CurrentTime, 0, 0);
        else if (e.type == ClientMessage && e.xclient.message_type == named("XdndFinished"))
            return e.xclient.data.l[1] == 0;   /* GLFW answers with the number of bytes, not with the flag 1 */
    }
}
