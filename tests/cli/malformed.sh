# Texts that are no scenes.

malformed_scenes_end_with_a_place_and_touch_no_picture() {
    "$PYTHON" "$root/tests/cli/malformed.py" "$povc" "$root/scenes/test"
}

malformed_by_cutting_every_scene_before_every_token() {
    every=1
    nm "$BUILD_DIR/bin/povc" | grep -qE '__(asan|tsan|ubsan)' && every=20
    "$PYTHON" "$root/tests/cli/cuts.py" "$povc" "$root/scenes/test" "$every"
}
