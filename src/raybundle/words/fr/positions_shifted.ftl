positions_shifted = Points d'appui et positions ({ $antenna }) diffèrent de { $plan } { $unit } en plan et de { $height } { $unit } en altitude.

positions_shifted-height = Points d'appui et positions ({ $antenna }) diffèrent de { $height } { $unit } en altitude.
