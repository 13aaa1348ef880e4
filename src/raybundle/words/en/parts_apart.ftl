# $what = "photograph"
# $parts = 2
# $n = 40
parts_apart = The { $what ->
        [photograph] photographs
        [scene] scenes
        [panorama] panoramas
       *[image] images
    } form { $parts } parts without connection; this result has { $n } of them.
    .do = Take photographs of both sides of each gap, or mark three control points in each part.

# $what = "image"
# $parts = 2
# $n = 40
parts_apart-scenes = The { $what ->
        [photograph] photographs
        [scene] scenes
        [panorama] panoramas
       *[image] images
    } form { $parts } parts without connection; this result has { $n } of them.
    .do = Mark three points in the scenes and in two photographs of each other part.

# $folder = "result-2"
# $scenes = 0
# $panoramas = 0
# $photographs = 12
# $names = ["a.jpg", "b.jpg"]
parts_apart-part = { $folder }: { $photographs ->
        [0] {""}
        [one] 1 photograph
       *[other] { $photographs } photographs
    }{ $panoramas ->
        [0] {""}
        [one] {" "}1 panorama
       *[other] {" "}{ $panoramas } panoramas
    }{ $scenes ->
        [0] {""}
        [one] {" "}1 scene
       *[other] {" "}{ $scenes } scenes
    } ({ LIST($names, most: 3) }).
