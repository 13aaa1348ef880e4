# $scenes = 2
scene_joins = Tie points of photographs were found in { $scenes } { $scenes ->
        [one] scene
       *[other] scenes
    }.

# $n = 40
# $scene = "scene_1"
scene_joins-scene = Scene { $scene } contains { $n } tie { $n ->
        [one] point
        *[other] points
    } of photographs.
