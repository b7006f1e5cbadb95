# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the wished accuracy will cost, beside its input: found in a thread, so that the panel never waits."""

import funicular as fn
from funicular.gui.background import Background
from funicular.gui.lengths import length_in_words
from funicular.gui.qt import translate
from funicular.gui.texts import BUSY, WrappedText
from funicular.wording import number, time_text


class PriceTag(WrappedText):
    """Quiet lines: "about 0.2 s", "Within 1 mm of the smooth form: step 40 cm, 50 ms".

    Empty until something is known, and as high then, so that what stands below does not jump.
    """

    LEAST_LINES = 3

    def __init__(self):
        super().__init__()
        self.setObjectName("PriceTag")
        self.set_colour(BUSY)
        self.setToolTip(
            translate(
                "What a solve to this accuracy takes, as predicted. Below it the largest step that brings "
                "the net as near to the smooth surface that it stands for, which is no error where members "
                "are the straight beams that will be built."
            )
        )
        self._background = Background(self, self.setText)

    def ask(self, scene, accuracy, seconds):
        """Find the price of a scene. accuracy: [m]. seconds: what its last solve took, to learn from, or
        None."""
        self._background.ask(lambda is_wanted: _price_in_words(scene, accuracy, seconds, is_wanted))

    def stop(self):
        """No price is wanted any more."""
        self._background.stop()
        self.setText("")


def _price_in_words(scene, accuracy, seconds, is_wanted):
    """Empty where no price can be told: it is a service, and the solve itself says what is wrong."""
    try:
        price = fn.predict(scene, accuracy)
        if seconds is not None:
            price.observe(seconds)
    except Exception:
        return ""
    words = translate("about {}").format(time_text(price.seconds))
    if not is_wanted():
        return words
    try:
        settings = fn.cheapest(scene, accuracy)
    except Exception:
        # No lattice, or no smooth surface: then there is no step to tell.
        return words
    words += "\n" + translate("Within {} of the smooth form: step {}, {}").format(
        length_in_words(accuracy), length_in_words(settings.step), time_text(settings.seconds)
    )
    if settings.lines != 1.0:
        words += translate(", each member with {} of EA and weight").format(number(settings.lines, ".3g"))
    return words
