flight_line-count = { $n } numéros de bande sont donnés pour { $images } images.

flight_line-too_few_images = Aucune bande n'a { $least } images avec position ou attitude observée.

flight_line-several_instruments = { $line_name } : ses images ont été observées avec plusieurs instruments ({ $names }).
