studio_product-title = Products
    .title = Surface, orthophoto, drawing, volumes, profiles, exchange files, archive

studio_product-plan = Plan
    .title = Orthophoto, heights and pictures; draw areas and lines on them

studio_product-surface = Surface

studio_product-facade = Elevation

studio_product-volume = Volume

studio_product-section = Profile

studio_product-contours = Contours

studio_product-exchange = Exchange files

studio_product-archive = Archive

studio_product-pages = Pages
    .title = The surface in space with standard deviations as colours; its quality

studio_product-page = Page

studio_product-files = Files

studio_product-about_surface = Point cloud of the current result, with standard deviations. With cell sizes also heights (DSM), orthophoto and mesh.

studio_product-about_facade = Elevation of a wall: true orthophoto, sheet to scale (PDF), drawing (DXF), sections.

studio_product-about_volume = Volume above and below a base, with standard deviations. Draw the area on the plan.

studio_product-about_section = Profile along a line: table, picture, drawing. Draw the line on the plan.

studio_product-about_contours = Contours of the heights for GIS and CAD.

studio_product-about_exchange = Files for other programs: GIS, CAD, COLMAP, Metashape, OPF, LAS.

studio_product-about_archive = One package for deposit: result, record, parameters, checksums (RO-Crate).

studio_product-make = Make
    .title = Run this command in the background

studio_product-picture = Picture

studio_product-draw_area = Draw an area
    .title = Click the corners; Backspace removes the last one, Escape all

studio_product-draw_line = Draw a line
    .title = Click the corners; Backspace removes the last one, Escape all

studio_product-use_area = Volume of this area

studio_product-use_line = Profile along this line

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
