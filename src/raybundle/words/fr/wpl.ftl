wpl-no_header = La première ligne n'est pas { $head }.
