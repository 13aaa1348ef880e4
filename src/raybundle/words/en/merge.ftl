# $entry = 1
# $kind = "str"
merge-no_block = blocks[{ $entry }] is of type { $kind }, not a block.
    .do = Read a folder with read_block first.

# $value = "'point'"
merge-prefer_no_mapping = prefer = { $value } is not a mapping.
    .do = Give, for instance, prefer=dict(point=0).

# $name = "points"
# $block = 2
# $known = ["image", "point"]
# $n = 2
merge-prefer_unknown = prefer: entry { $name } = { $block } is invalid.
    .do = Give one of { LIST($known, most: 9) } and the position of one of the { $n } blocks, from 0.

merge-no_blocks = There are no blocks to merge.
    .do = Give at least one block.

# $name = "d5100: model"
# $value = "brown"
# $other = "fisheye"
# $block = "north"
# $other_block = "south"
# $first = 0
# $second = 1
# $subject = "camera"
merge-contradiction = { $name } is { $value } in block { $first } ({ $block }), { $other } in block { $second } ({ $other_block }).
    .do = Correct one of them, or choose the block that has priority: prefer=dict({ $subject }={ $first }).

# $name = "distances.csv: P1 - P2"
# $entry = "sigma"
merge-do_not_fit = The blocks do not fit together: { $name }, { $entry }.
    .do = Correct this entry in one of the blocks.
