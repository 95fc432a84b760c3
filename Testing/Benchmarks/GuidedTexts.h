// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Texts of ReflectionTables.md above the tables of GuidedStudy.cxx.

#ifndef SeismicHorizonsGuidedTexts_h
#define SeismicHorizonsGuidedTexts_h

namespace SeismicHorizons
{
constexpr const char* GuidedText = R"(## Guided

Five picks per piece find most of a horizon, even if some of them are wrong. %d wild cubes (`generate_cube --wild`) of
110 x 96 traces of 280 samples: hard cubes with an unconformity, two channels, and one to four short faults. Half of the
noise is in band, a quarter is white, and a quarter is dipping waves. *Picks* are random in each piece of a reflector
(100 or more connected columns), or all picks on every 20th line. Entries are percentages: *found* / *weakest* / *off*,
picks more than half a period from the reflector / *absent*, picks where there is none. Without picks, the best surface
of each piece is evaluated. The *plain tracker*, for comparison, knows the picks and the true period, and grows only
from the picks, best correlation first.
)";

constexpr const char* ConfidenceText = R"(
## Confidence

The array `Confidence` of guided horizons in the same cubes, in bins. Entries are percentages: points in the bin, then
of these their mean confidence / those within half a period of the reflector / those *off*, where the reflector exists.

)";

constexpr const char* TroublesText = R"(
## Other troubles

Parts of wild cubes, of 90 x 80 traces, with 25 % noise: half white, half in band and similar in neighbouring columns,
as after migration. Each has one more problem (`generate_cube --trouble`): clinoforms that downlap on the unconformity,
amplitudes clipped to 8 bits, three strips of dead traces, an acquisition footprint, a gas cloud that weakens and
delays, a growth fault with rollover and drag, multiples that cross reflectors, polarity that reverses along every
reflector, a bright reef with steep flanks, a salt plug with upturned flanks, smiles of migration, residual statics, or
a wavelet whose frequency falls to 0.4 of its value. Entries as under *Guided*.

)";

constexpr const char* SamplingText = R"(
## Fine sampling

Parts of wild cubes, of 70 x 60 traces, sampled more and more finely, with white noise. Entries as under *Guided*. With
picks, traces with more than 2.5 peaks in half a period are smoothed first, so that no less is found.

)";
}

#endif
