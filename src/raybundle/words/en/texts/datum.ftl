datum-control = control

# $n = 7
# $names = ["tX", "tY", "tZ"]
datum-minimal = minimal: { $n } coordinates of well-spread object points held ({ $names })

# $over = "all"
# $n = 0
# $parts = "all"
# $names = ["tX", "tY", "tZ"]
datum-inner = inner constraints over { $over ->
        [all] all object points
        [chosen] { $n } chosen object points
        *[good] { $n } well-determined object points
    }{ $parts ->
        [all] {""}
        *[some] {" "}for { $names }
    }
