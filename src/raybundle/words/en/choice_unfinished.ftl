# $steps = 40
# $free = 12
# $cameras = 2
# $ids = ["d5100"]
choice_unfinished = The choice of parameters stopped after { $steps } steps; { $free } parameters of { $cameras } { $cameras ->
        [one] camera
       *[other] cameras
     } are free.
    .why = Some of them may not be significant.
    .do = Name the parameters to hold: { OPTION("hold") }.
