studio_target-found = found

studio_target-used = used

studio_target-rejected = rejected

studio_target-apart = not in the block

studio_target-unidentified = unidentified

# $fate = "used"
studio_target-fate = { $fate ->
        [used] used
        [rejected] rejected
        [apart] not in the block
        *[unidentified] unidentified
    }

# $fate = "used"
studio_target-legend = { $fate ->
        [used] target used
        [rejected] target rejected
        [apart] target not in the block
        *[unidentified] dot without a name
    }

studio_target-median_sigma = median sigma [px]

studio_target-source = source

# $origin = "studio"
studio_target-origin = { $origin ->
        [calibrate] stored by calibrate
        *[studio] found in the studio
    }

studio_target-not_found = not searched yet

studio_target-family = family

# $names = "aicon14; agisoft12"
studio_target-families = Known families: { $names }.

studio_target-family_missing = Give the family of the photographed targets.

studio_target-name_family = Give the family of the targets under Decide, Targets.

studio_target-none_stored = No targets of this family are stored.
    .do = Find them in all photographs, or show one photograph with its targets.

studio_target-find = Find in all photographs
    .title = Find the targets in the background; Stop ends the search

studio_target-finding = Finding targets.

# $n = 1
# $image = "a.jpg"
studio_target-found_in = Targets found in { $n ->
        [one] { $image }
        *[other] { $n } photographs
    }.

# $image = "a.jpg"
studio_target-in_image = targets in { $image }

studio_target-by_photograph = Targets by photograph

# $image = "a.jpg"
# $n = 42
studio_target-of_image = Targets of { $image }: { $n }

# $image = "a.jpg"
studio_target-show = Show { $image } with its targets

studio_target-sigma = sigma [px]

studio_target-semi_axis_a = semi-axis a [px]

studio_target-semi_axis_b = b [px]

studio_target-sheet = Sheet to print

studio_target-sheet_note = Print without scaling, and measure the scale bar on the paper.
    .why = raybundle calibrate reads the TOML file of the sheet.

studio_target-make_sheet = Make the sheet
    .title = Make a PDF at true size and a TOML file of its contents

studio_target-sheet_made = The sheet is made.
