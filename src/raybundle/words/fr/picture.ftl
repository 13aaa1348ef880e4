picture-no_scale = L'échelle de l'image est inconnue : { $plane } et { $world } manquent.

picture-other_system = L'image est en { $picture }, le bloc en { $block }.

picture-earlier_adjustment = L'image vient d'une compensation antérieure : { $photograph } a bougé de { $offset } { $unit }.

picture-suffix = Le nom de l'image ne finit pas par { LIST($known, most: 8) }.

picture-not_geotiff = L'image ne peut être écrite en GeoTIFF ({ $detail }).
