# $camera = "474x345"
# $off = 0.14
# $limit = 0.1
# $ids = ["IMG_5"]
cropped_photographs = Camera { $camera }: principal point { PERCENT($off) } % of the format beside its middle (limit { PERCENT($limit) } %): { LIST($ids, most: 4) }.
    .why = The photographs were cropped, or taken with a shift lens; their positions depend on this camera alone.
    .do = Use the photographs as they were taken, or give the calibration of the cropped format.
