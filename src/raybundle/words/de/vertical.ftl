vertical-unknown_way = { OPTION("up") } ist { $way }.
    .do = auto, terrestrial, aerial, oblique oder zwei Punkte A,B von { OPTION("control") } angeben, B lotrecht über A.

vertical-point_without_place = { OPTION("up") }: Punkt { $point } hat keine Koordinaten.
    .do = Den Punkt in zwei Aufnahmen messen ({ OPTION("control") }).

vertical-same_place = { OPTION("up") }: Die Punkte { $first } und { $second } liegen an derselben Stelle.
    .do = Zwei Punkte angeben, den zweiten lotrecht über dem ersten.

vertical-no_plumb_line = { OPTION("up", $way) }: Der Block hat keine gemessene Lotlinie mit zwei Punkten.
    .do = Eine Lotlinie messen oder { OPTION("up", "A,B") } angeben, mit B lotrecht über A.

vertical-way_unknown = { OPTION("up", $way) } ist nicht möglich.
    .do = z, lines oder zwei Punkte A,B angeben, mit B lotrecht über A.

vertical-points_coincide = { OPTION("up", $way) }: Die Punkte liegen am selben Ort.
    .do = Zwei Punkte angeben, die auseinanderliegen.
