check_points_open = Les points de contrôle ne sont pas comparés en { $axes } ; non déterminé : { datum-part }.
