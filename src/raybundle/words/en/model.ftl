# $camera = "d5100"
# $model = "fisheye"
# $other = "brown"
# $sigma0 = 1.02
model = Camera { $camera }: model { $model } fits the photographs better than { $other } (sigma0 { $sigma0 }).

# $name = "brwon"
# $known = ["brown", "fisheye"]
model-unknown_sensor = There is no sensor model { $name }.
    .do = Use one of { LIST($known, most: 40) }.
