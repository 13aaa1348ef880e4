studio_product-title = Products
    .title = Surface, orthophoto, drawing, volumes, profiles, exchange files, archive

# $part = "surface"
studio_product-part = { $part ->
        [plan] Plan
        [surface] Surface
        [facade] Elevation
        [volume] Volume
        [section] Profile
        [contours] Contours
        [drawing] Drawing
        [exchange] Exchange files
        [archive] Archive
        [pages] Pages
        *[files] Files
    }

# $product = "surface"
studio_product-about = { $product ->
        [surface] Points with standard deviations; with cell sizes also heights (DSM), orthophoto, mesh.
        [facade] Elevation of a wall: true orthophoto, sheet to scale (PDF), drawing (DXF), sections.
        [volume] Volume above and below a base, with standard deviations. Draw the area on the plan.
        [section] Profile along a line: table, picture, drawing. Draw the line on the plan.
        [contours] Contours of the heights for GIS and CAD.
        [drawing] Lines and areas drawn on the plan, with heights, for CAD and GIS.
        [exchange] Files for other programs: GIS, CAD, COLMAP, Metashape, OPF, LAS.
        *[archive] One package for deposit: result, record, parameters, checksums (RO-Crate).
    }

# $shape = "area"
studio_product-draw = { $shape ->
        [area] Draw an area
        *[line] Draw a line
    }
    .title = Click the corners; Backspace removes the last one, Escape all

# $shape = "area"
studio_product-use = { $shape ->
        [area] Volume of this area
        *[line] Profile along this line
    }

studio_product-name = Name

studio_product-layer = Layer

studio_product-note = Note

studio_product-keep = Keep
    .title = Keep what is drawn in the project; Undo takes it back

# $name = "edge"
studio_product-kept = { $name } kept.

studio_product-drawings = Drawings

# $shape = "area"
# $n = 3
studio_product-default_name = { $shape ->
        [area] area
        *[line] line
    } { $n }

# $name = "edge"
studio_product-erase = Remove { $name }

# $name = "edge"
studio_product-erased = { $name } removed.

# $name = "edge"
studio_product-edit = Edit { $name }

studio_product-page = Page

studio_product-make = Make
    .title = Run this command in the background

studio_product-picture = Picture

studio_product-clear = Clear

studio_product-show = Show

studio_product-no_files = No products yet.

studio_product-no_picture = No pictures yet. Make a surface with an orthophoto first.

# $n = 120
studio_product-more = { $n } more files are in the folder.

# $x = "12.34"
# $y = "5.67"
# $z = "1.234"
# $s = "0.0021"
studio_product-place = X { $x }, Y { $y }{ $z ->
        [none] {""}
        *[other] , height { $z }
    }{ $s ->
        [none] {""}
        *[other] , standard deviation { $s }
    }
