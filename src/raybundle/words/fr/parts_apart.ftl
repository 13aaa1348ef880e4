parts_apart = Les images forment { $parts } parties sans liaison ; ce résultat en contient { $n }.

parts_apart-scenes = Les images forment { $parts } parties sans liaison ; ce résultat en contient { $n }.

parts_apart-part = { $folder } : { $photographs } photographies, { $panoramas } panoramas, { $scenes } scènes ({ LIST($names, most: 3) }).
