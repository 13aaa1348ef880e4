# $before = 0.12
# $limit = 0.04
# $after = 0.01
# $pairs = 2
# $names = ["IMG_1 - IMG_9", "IMG_2 - IMG_8"]
repeated_structure = Repeated structure: { PERCENT($before) } % of the matches contradict others (limit { PERCENT($limit) } %).
    .why = { $pairs ->
     [0] No pair is left out.
     [one] One pair of photographs of similar parts is left out: { LIST($names, most: 4) }.
     *[other] { $pairs } pairs of photographs of similar parts are left out: { LIST($names, most: 4) }.
    } Of the rest, { PERCENT($after) } % contradict, which is usual.
    .do = Compare the positions of the photographs with where they were taken.

# $before = 0.32
# $limit = 0.04
# $after = 0.2
# $pairs = 2
# $names = ["IMG_1 - IMG_9", "IMG_2 - IMG_8"]
repeated_structure-ambiguous = Repeated structure: { PERCENT($after) } % of the matches contradict others (limit { PERCENT($limit) } %).
    .why = { $pairs ->
     [0] No pair is left out.
     [one] One pair of photographs of similar parts is left out: { LIST($names, most: 4) } ({ PERCENT($before) } % before).
     *[other] { $pairs } pairs of photographs of similar parts are left out: { LIST($names, most: 4) } ({ PERCENT($before) } % before).
    } Photographs may be oriented at the wrong part of the object.
    .do = Compare their positions with where they were taken; take them closer together, or put up coded targets.

# $groups = 2
# $barren = 0.4
# $limit = 0.1
# $within = 0.02
# $known = true
# $ids = ["IMG_7", "IMG_8"]
repeated_structure-groups = Repeated structure: { $groups } groups of photographs may show different parts that look alike.
    .why = Between them { PERCENT($barren) } % of the common surface has no common point (limit { PERCENT($limit) } %{ $known ->
     [yes] , within the groups { PERCENT($within) } %
     *[no] { "" }
    }).
    .do = Compare their positions with where they were taken; take photographs between the groups, or put up coded targets.

# $n = 6
# $names = ["IMG_1", "IMG_2", "IMG_3", "IMG_4"]
repeated_structure-group = Group of { $n } { $n ->
     [one] photograph
     *[other] photographs
    }: { LIST($names, most: 4) }
