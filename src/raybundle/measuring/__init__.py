"""Measuring by hand: actions, their journal, what they make of a block, predicted places, snapping to the picture.

    journal   the actions, one after the other, kept for good
    actions   one small type a verb
    state     what the actions add up to
    merge     state and block make a block
    start     photographs without orientation: oriented from their marks, or what they lack
    film      scans of film: where they lie by their fiducial marks
    session   a block with its adjustment, which answers where points should be seen
    predict   predicted places, epipolar lines, intersections, each with its covariance
    snap      a click brought to the picture
    query     coordinates, distances, angles, areas of a result, from the full covariance

Nothing here knows of command lines or browsers.
"""
