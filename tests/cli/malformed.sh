# Texts that are no scenes.

malformed_scenes_end_with_a_place_and_touch_no_picture() {
    "$PYTHON" "$root/tests/cli/malformed.py" "$povc" "$root/scenes/test"
}
