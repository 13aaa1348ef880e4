plane-points_in_line = Plan { $name } : ses points sont alignés.
