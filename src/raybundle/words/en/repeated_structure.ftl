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

# $after = 0.3
# $limit = 0.06
# $first = ["IMG_1", "IMG_2"]
# $second = ["IMG_8", "IMG_9"]
# $ids = ["IMG_1", "IMG_2", "IMG_8", "IMG_9"]
repeated_structure-missing = Repeated structure: two groups of photographs may show different parts that look alike.
    .why = On { PERCENT($after) } % of the surface that they share, one photograph shows points and the other none (limit { PERCENT($limit) } %): { LIST($first, most: 4) }; { LIST($second, most: 4) }.
    .do = Compare their positions with where they were taken; take photographs that show both parts together, or put up coded targets.

# $before = 0.4
# $after = 0.01
# $limit = 0.06
# $first = ["IMG_1", "IMG_2"]
# $second = ["IMG_8", "IMG_9"]
# $ids = ["IMG_1", "IMG_2", "IMG_8", "IMG_9"]
repeated_structure-rearranged = Repeated structure: two groups of photographs of similar parts were placed anew.
    .why = Placed together, one photograph shows points and the other none on { PERCENT($before) } % of the shared surface (limit { PERCENT($limit) } %), placed anew on { PERCENT($after) } %: { LIST($first, most: 4) }; { LIST($second, most: 4) }.
    .do = If they stand in separate parts, take photographs that show both parts together.

# $parts = 2
# $lost = 1
# $pairs = 4
# $names = ["IMG_1 - IMG_9", "IMG_2 - IMG_8"]
# $ids = ["IMG_1", "IMG_9", "IMG_2", "IMG_8"]
repeated_structure-unsettled = Repeated structure: { $pairs } pairs of photographs match well and contradict the orientation.
    .why = Number of parts: { $parts }; photographs without orientation: { $lost }. Photographs may be oriented at the wrong part of the object: { LIST($names, most: 4) }.
    .do = Compare their positions with where they were taken; take photographs with more overlap, or put up coded targets.
