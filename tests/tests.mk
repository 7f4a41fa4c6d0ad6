# Tests: every tests/<room>/test_*.c is a cmocka program linked with the static library.
TEST_SOURCES  = $(sort $(wildcard tests/*/test_*.c))
TEST_PROGRAMS = $(TEST_SOURCES:%.c=$(BUILD)/%)
SUPPORT_OBJECTS = $(patsubst %.c,$(BUILD)/obj/%.o,$(sort $(wildcard tests/support/*.c)))
# Where tests find what was built, and the tree's scenes.
TEST_PATHS = -DTEST_BUILD='"$(abspath $(BUILD))"' -DTEST_ROOT='"$(CURDIR)"'

$(BUILD)/obj/tests/%.o: tests/%.c
	@mkdir -p $(@D)
	$(CC) $(LIB_FLAGS) -Itests $(TEST_PATHS) -c $< -o $@

$(BUILD)/tests/%: $(BUILD)/obj/tests/%.o $(SUPPORT_OBJECTS) $(STATIC)
	@mkdir -p $(@D)
	$(CC) $(LINK_FLAGS) $(filter %.o,$^) $(STATIC) -lcmocka $(TEST_LIBS) $(SYSTEM_LIBS) -o $@

$(BUILD)/tests/numerics/%: TEST_LIBS = -lmpfr -lgmp

$(BUILD)/tests/plugins/test_images: TEST_LIBS = -lpng
$(BUILD)/tests/plugins/test_images: | $(IMAGES)
$(BUILD)/obj/tests/plugins/test_images.o: LIB_FLAGS += $(shell $(PKG_CONFIG) --cflags libpng)
# The pure pieces of povc are tested with the program's own objects.
$(BUILD)/obj/tests/cli/%.o: LIB_FLAGS += -Icli
$(BUILD)/tests/cli/test_args: $(BUILD)/obj/cli/args.o
$(BUILD)/tests/cli/test_text: $(BUILD)/obj/cli/text.o
$(BUILD)/tests/cli/test_progress: $(BUILD)/obj/cli/progress.o
