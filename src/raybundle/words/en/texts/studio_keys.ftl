studio_keys-title = Keys

studio_keys-anywhere = Everywhere

studio_keys-in_photograph = In a photograph

studio_keys-by_mouse = Mouse

studio_keys-new_point = new point

studio_keys-next_image = next image in which the current point is visible and not measured

studio_keys-worst = next of the worst

studio_keys-ctrl_z = Ctrl Z

studio_keys-undo = undo

studio_keys-ctrl_shift_z = Ctrl Shift Z

studio_keys-redo = redo

studio_keys-snap = next kind of snapping

studio_keys-loupe = loupe: while held, or on and off

studio_keys-centre = centre all images on the current point

studio_keys-panes = 1, 2 or 4 images

studio_keys-neighbour = previous, next image

studio_keys-no_point = no current point

studio_keys-name = type the name of a point

studio_keys-this_table = this table

studio_keys-arrows = Arrow keys

studio_keys-hair = move the cross hair; with Ctrl by 1 px

studio_keys-mark = measure the current point at the cross hair

studio_keys-shift_arrows = Shift and arrows

studio_keys-move = move the mark of the current point by 0.1 px; with Alt by 0.01 px

studio_keys-delete = Delete

studio_keys-remove = remove the mark

studio_keys-choose = choose the image point here

studio_keys-reject = reject the image observation here, or accept it again

studio_keys-of_mask = Enter, Delete, Esc

studio_keys-mask = while drawing a mask: add a corner, remove the last, cancel

studio_keys-zoom = zoom

studio_keys-whole = whole photograph

studio_keys-pixels = pixel by pixel

studio_keys-turn = turn

studio_keys-click = Click

studio_keys-click_deed = measure the current point; on a mark: choose it

studio_keys-ctrl_click = Ctrl click

studio_keys-drag = Drag

studio_keys-drag_deed = move the photograph, or a mark

studio_keys-wheel = Wheel

studio_keys-shift_click = Shift click in the list

studio_keys-beside = open the image beside

studio_keys-close = Close
    .title = Close this table (Esc)
