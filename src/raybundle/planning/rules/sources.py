"""What the rules rest on in the literature, each with how much of it was at hand."""

from __future__ import annotations

from raybundle.planning.rules.rule import Source

FRASER_1984 = Source(
    who="Fraser 1984",
    what="Network design considerations for non-topographic photogrammetry, Photogrammetric Engineering and Remote "
    "Sensing 50(8), 1115-1126",
    states="design of a network in the orders of Grafarend (1974): datum, configuration, weights, densification; "
    "precision is decided by configuration and by the precision of what is measured; sigma = q S sigma_xy / sqrt(k)",
    read="abstract and first page; the formula as the report of an adjustment has it",
)  # fmt: skip
GRANSHAW_1980 = Source(
    who="Granshaw 1980",
    what="Bundle adjustment methods in engineering photogrammetry, Photogrammetric Record 10(56), 181-207",
    states="multi-station photography for engineering; inner accuracy and free networks as the measure by which "
    "networks compare",
    read="abstract and introduction",
)  # fmt: skip
YORK_1982 = Source(
    who="Commission V of ISPRS, York 1982",
    what="Precision and Speed in Close Range Photogrammetry, part 1, paper on multi-station bundles, p. 237 f.",
    states="convergent photographs from several stations let the interior orientation be determined without control "
    "(as Kenefick and others 1972); an error along the epipolar line of a pair shows nowhere",
    read="two pages",
)
JAMES_2014 = Source(
    who="James and Robson 2014",
    what="Mitigating systematic error in topographic models derived from UAV and ground-based image networks, Earth "
    "Surface Processes and Landforms",
    states="self-calibration of near-parallel views gives wrong radial distortion, and the surface a dome; convergent "
    "views mend it",
    read="abstract",
)
STRONER_2021 = Source(
    who="Štroner, Urban, Seidl, Reindl and Brouček 2021",
    what="Photogrammetry using UAV-mounted GNSS RTK: georeferencing strategies without GCPs, Remote Sensing 13(7), "
    "1336",
    states="with RTK and views straight down, heights are off in proportion to the error of the camera constant; "
    "oblique views together with those down bring it below 3 cm",
    read="abstract; its authors after the journal",
)
ACKERMANN_1980 = Source(
    who="Ackermann 1980",
    what="Blockadjustment with additional parameters, Congress of the International Society for Photogrammetry, "
    "Hamburg, Commission III",
    states="additional parameters are effective; which to take, and whether they are determinable, must be decided by "
    "tests",
    read="summary and introduction",
)
