attitudes_contradict = Les attitudes de { $source } contredisent les photographies et sont écartées.

attitudes_contradict-mounting = Le montage s'écarte de { NUM($off_deg, decimals: 0) }° d'un nombre entier de quarts de tour

attitudes_contradict-reading = Convention { $reading } : dispersion { NUM($scatter_deg, decimals: 2) }°
