# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Help, and wrong usage: exit status 2 and one line."""

import unittest

from program import ProgramTest

COMMANDS = ("sharpen", "classify", "edges", "regions", "contour", "compare", "demo")
SHARPEN = "sharpen box.vtp -o out.vtp "
CLASSIFY = "classify box.vtp -o out.vtp "
WRONG = {
    "": "a command is missing",
    "foo": "there is no command foo",
    "sharpen": "IN is required",
    "sharpen box.vtp": "--output is required",
    SHARPEN + "--bogus": "The following argument was not expected: --bogus",
    SHARPEN + "--method best": "--method: must be paper or robust, not best",
    SHARPEN + "--threads 0": "--threads: must be a whole number from 1 to 1024, not 0",
    SHARPEN + "--threads 1.5": "--threads: must be a whole number from 1 to 1024, not 1.5",
    SHARPEN + "--window-search spatial": "--window-search: applies to --method paper only",
    SHARPEN + "--method paper --denoise": "--denoise: applies to --method robust only",
    SHARPEN + "--method paper --allow-flips": "--allow-flips: applies to --method robust only",
    SHARPEN + "--method paper --window 1 --window-ratio 1": "--window excludes --window-ratio",
    SHARPEN + "--method paper --window -1": "--window: must be a number greater than 0, not -1",
    SHARPEN + "--method paper --window inf": "--window: must be a number greater than 0, not inf",
    CLASSIFY + "--sharp-at 1,2": "--sharp-at: must be three numbers, as in 1,2.5,-3, not 1,2",
    CLASSIFY + "--smooth-at 1,2,inf": "--smooth-at: must be three numbers",
    CLASSIFY + "--sharp-at 1,2,3 --window 1": "--window excludes --sharp-at",
    CLASSIFY + "--window-ratio 0": "--window-ratio: must be a number greater than 0, not 0",
    CLASSIFY + "--window-search far": "--window-search: must be connected or spatial",
    "contour box.vtp -o out.vtp": "--value is required",
    "contour box.vtp -o out.vtp --value abc": "--value: must be a finite number, not abc",
    "contour box.vtp -o out.vtp --value nan": "--value: must be a finite number, not nan",
    "compare box.vtp box.vtp --samples 0": "--samples: must be a whole number from 1 to",
}
ANGLE = "must be an angle greater than 0 and at most 180 degrees, not "


class Usage(ProgramTest):
    def test_version(self):
        self.assertRegex(self.assert_done("--version"), r"^arris \d+\.\d+\.\d+\n$")

    def test_help(self):
        said = self.assert_done("--help")
        for command in COMMANDS:
            self.assertIn(f"\n  {command} ", said)
            own = self.assert_done(command, "--help")
            self.assertIn("--quiet", own)
            self.assertNotEqual(own, said)

    def test_wrong(self):
        for arguments, text in WRONG.items():
            with self.subTest(arguments):
                self.assert_fails(text, *arguments.split(), status=2)

    def test_wrong_angles(self):
        for angle in ("200", "0", "nan", "abc"):
            for command, option in (("classify", "--sharp-angle"), ("edges", "--feature-angle")):
                with self.subTest(option + " " + angle):
                    text = f"{option}: {ANGLE}{angle}"
                    args = (command, "box.vtp", "-o", "out.vtp", option, angle)
                    self.assert_fails(text, *args, status=2)


if __name__ == "__main__":
    unittest.main()
