# $n = 2
# $limit = 0.5
# $largest = 0.83
# $false_alarms = 0.034
# $ids = ["IMG_7", "IMG_8"]
wrong_stations = { $n } { $n ->
        [one] station is
       *[other] stations are
    } wrong with a probability above { PERCENT($limit) } %: { LIST($ids, most: 4) }.
    .why = The largest probability is { PERCENT($largest) } %. Wrong: more than 1 % of the extent or 1° off. { PERCENT($false_alarms) } % of right stations are named like this.
    .do = Look at these photographs; add photographs that overlap with them, or leave them out.
