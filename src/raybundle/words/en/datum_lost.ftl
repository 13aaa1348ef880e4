# $part = "scale"
datum_lost = The earlier result in this folder had a datum that this one lacks: { datum-part }.
    .why = The last run had control, positions or scale bars that are missing now, or take no part.
    .do = Give them again ({ OPTION("control") }, { OPTION("scale_bar") }), or another { OPTION("out") }.
