# povview. Built where pkg-config finds what it draws with; else the rest still is.
VIEWER_PACKAGES = glfw3 osmesa cairo
VIEWER_SOURCES  = $(sort $(wildcard viewer/*.c))
VIEWER_OBJECTS  = $(VIEWER_SOURCES:%.c=$(BUILD)/obj/%.o)
# Tests of what needs none of the packages are built everywhere.
VIEWER_PURE_TESTS = tests/viewer/test_orbit.c tests/viewer/test_app.c tests/viewer/test_args.c tests/viewer/test_keys.c \
                    tests/viewer/test_camera_text.c tests/viewer/test_zoom.c tests/viewer/test_bar.c \
                    tests/viewer/test_recent.c
POVVIEW         = $(BUILD)/bin/povview

$(BUILD)/obj/viewer/%.o: ROOM_FLAGS = $(VIEWER_FLAGS) -Iviewer
$(BUILD)/obj/tests/viewer/%.o: ROOM_FLAGS += $(VIEWER_FLAGS) -Iviewer
VIEWER_PURE = $(patsubst %,$(BUILD)/obj/viewer/%.o,orbit zoom bar ramp add app keys args script camera_text recent)
$(VIEWER_PURE_TESTS:%.c=$(BUILD)/%): $(VIEWER_PURE)

VIEWER_SCRIPTS = tests/viewer/examples.sh

ifeq ($(shell $(PKG_CONFIG) --exists $(VIEWER_PACKAGES) && echo yes),yes)

# Neither libGL nor libOSMesa is linked: each OpenGL call is fetched from the surface.
VIEWER_FLAGS := $(shell $(PKG_CONFIG) --cflags $(VIEWER_PACKAGES))
VIEWER_LIBS  := $(shell $(PKG_CONFIG) --libs glfw3 cairo)

runtime: $(POVVIEW)

$(POVVIEW): PROGRAM_LIBS = $(VIEWER_LIBS) $(SYSTEM_LIBS)
$(POVVIEW): $(VIEWER_OBJECTS) $(SHARED)
	$(call LINK_PROGRAM,$$ORIGIN/../lib)

$(BUILD)/tests/viewer/test_shot $(BUILD)/tests/viewer/test_pixels: $(filter-out $(BUILD)/obj/viewer/main.o,$(VIEWER_OBJECTS))
$(BUILD)/tests/viewer/test_shot $(BUILD)/tests/viewer/test_pixels: TEST_LIBS = $(VIEWER_LIBS)

.PHONY: install-viewer uninstall-viewer
install: install-viewer
install-viewer: all
	$(INSTALL) -d $(DESTDIR)$(BINDIR) $(DESTDIR)$(MANDIR)/man1 $(addprefix $(DESTDIR),$(COMPLETIONDIR) $(ZSHDIR) $(FISHDIR))
	@mkdir -p $(BUILD)/install
	$(CC) $(LINK_FLAGS) $(VIEWER_OBJECTS) -L$(BUILD)/lib -lpovtrace -Wl,-rpath,'$(INSTALL_RPATH)' $(VIEWER_LIBS) \
	    $(SYSTEM_LIBS) -o $(BUILD)/install/povview
	$(INSTALL) -m 755 $(BUILD)/install/povview $(DESTDIR)$(BINDIR)
	$(INSTALL) -m 644 docs/man/povview.1 $(DESTDIR)$(MANDIR)/man1
	$(INSTALL) -m 644 share/completions/povview.bash $(DESTDIR)$(COMPLETIONDIR)/povview
	$(INSTALL) -m 644 share/completions/_povview $(DESTDIR)$(ZSHDIR)
	$(INSTALL) -m 644 share/completions/povview.fish $(DESTDIR)$(FISHDIR)

uninstall: uninstall-viewer
uninstall-viewer:
	rm -f $(DESTDIR)$(BINDIR)/povview $(DESTDIR)$(MANDIR)/man1/povview.1 $(DESTDIR)$(COMPLETIONDIR)/povview \
	    $(DESTDIR)$(ZSHDIR)/_povview $(DESTDIR)$(FISHDIR)/povview.fish

# The real window is tested where there is something to show it on.
ifneq ($(and $(shell command -v Xvfb),$(shell command -v xdotool),$(shell command -v import)),)
VIEWER_SCRIPTS += tests/viewer/window.sh
else
tests: no-window
.PHONY: no-window
no-window:
	@echo "the test of the window was left out: it needs Xvfb, xdotool and ImageMagick"
endif

else

TESTS_LEFT_OUT += $(filter-out $(VIEWER_PURE_TESTS),$(wildcard tests/viewer/test_*.c))

runtime: no-viewer
.PHONY: no-viewer
no-viewer:
	@echo "povview was left out: pkg-config does not find all of $(VIEWER_PACKAGES)"

endif
