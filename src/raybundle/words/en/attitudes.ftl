# $n = 20
# $convention = "opk"
# $source = "ins.csv"
# $cameras = 1
attitudes = Attitudes of { $n } { $n ->
     [one] photograph
     *[other] photographs
    } observed ({ $convention }, from { $source ->
     [gimbal] the gimbal
     *[other] { $source }
    }){ $cameras ->
     [0] { "" }
     [one] { "" }, with the misalignment of one camera
     *[other] { "" }, with the misalignment of { $cameras } cameras
    }.
