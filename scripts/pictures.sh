#!/usr/bin/env bash
# make pictures: builds the drawing examples against the installation in $1, and redraws the pictures of docs/ with
# equal bytes, except the plot of the benchmarks. It also writes the page of showcases, which begins with the showcase
# of `make demo`. The remaining arguments are the Debian packages it needs.
set -euo pipefail
cd "$(dirname "$0")/.."
stage=$1
shift
scripts/install-packages.sh "$@"
for project in pictures workshop; do
  cmake -S examples/$project -B build/$project -DGUSSET_PREFIX="$stage" >build/$project.log 2>&1 &&
    env -u MAKELEVEL -u MAKEFLAGS cmake --build build/$project --parallel 2 >>build/$project.log 2>&1 || { tail -n 40 build/$project.log; exit 1; }
done
build/pictures/gallery docs
build/pictures/outline - docs/outline.svg
build/pictures/hull - docs/hull.svg docs/hull_view.svg
build/pictures/scene build/pictures/scene.obj docs/scene.svg
build/workshop/last - --picture docs/workshop_last.svg --pattern docs/workshop_pattern.svg --page build/workshop/last.page
for name in ship wrist relief; do
  build/workshop/$name - --picture docs/workshop_$name.svg --page build/workshop/$name.page
done
scripts/demo.sh "$stage" '' '' "$@"
build/pictures/showcases build/pictures/gallery
python3 -B scripts/page.py "gusset: showcases" docs/showcases.html build/demo/showcase build/pictures/gallery \
  build/workshop/{last,ship,wrist,relief}.page
scripts/venv.sh build/python-hosts python/requirements.txt python/requirements-hosts.txt
(cd python && ../build/python-hosts/bin/python -B build_backend.py "$stage/lib/libgusset.so" gusset_mesh)
PYTHONPATH=python build/python-hosts/bin/python -B -c 'import gusset_mesh.pyvista, runpy, sys; sys.argv = ["pieces.py", "docs"]; runpy.run_path("examples/python/pieces.py")' >build/python.log 2>&1 || { cat build/python.log; exit 1; }
/usr/bin/python3 -B scripts/photograph.py docs/showcases.html 1600 720 docs/joined.jpg "show=demo&plain=1&named=1&theme=light&side=1"
