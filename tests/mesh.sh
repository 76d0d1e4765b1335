#!/usr/bin/env bash
# A sheet on a mesh as a user meets it: an OBJ file runs, its vertices in any order; what is
# wrong with one is a sentence with its file and line, and exit 2; so is what a model doesn't do
# on a mesh.
#   mesh.sh PROGRAM
program=$1
# shellcheck source=tests/fixture.sh
. "$(dirname "$0")/fixture.sh"

own_folder

grid() { # N: an OBJ of N x N points with vt, from the far corner on
    awk -v n="$1" 'BEGIN {
        for (k = n * n - 1; k >= 0; k--) {
            u = int(k / n) / (n - 1); v = k % n / (n - 1)
            printf "v %g %g 7\nvt %g %g\n", u, v, u, v
        }
        for (i = 0; i < n - 1; i++)
            for (j = 0; j < n - 1; j++) {
                a = n * n - (i * n + j); b = a - n
                printf "f %d/%d %d/%d %d/%d %d/%d\n", a, a, b, b, b - 1, b - 1, a - 1, a - 1
            }
    }'
}
set_mesh() { # SETTING...: of a short run
    local args=(run edge_drop --model triangles --set time.end=0.01 --set 'snapshots=[]')
    for setting in "$@"; do
        args+=(--set "discretization.$setting")
    done
    printf '%s\n' "${args[@]}"
}
runs() { mapfile -t args < <(set_mesh "$@"); good "${args[@]}"; }
says() { # SENTENCE SETTING...
    local sentence=$1
    shift
    mapfile -t args < <(set_mesh "$@")
    ends 2 "${args[@]}"
    grep -qF -- "$sentence" err || fail "$*: does not say '$sentence': $(<err)"
}

grid 6 >good.obj
for bending in quadratic midedge hinge; do
    runs mesh=good.obj "bending=$bending"
    runs mesh=irregular seed=3 'points=[6,5]' "bending=$bending" integrator=leapfrog
done
runs mesh=good.obj refine=1 bending=midedge arc=on integrator=implicit
runs mesh=diagonal 'points=[6,5]'

# a result file holds the mesh's name, and ends where the same run without a file does
cp good.obj 'a "mesh".obj'
mapfile -t args < <(set_mesh 'mesh=a "mesh".obj')
good "${args[@]}" --out result.h5
grep -aqF 'discretization.mesh="a \"mesh\".obj"' result.h5 || fail 'no mesh in the result file'

sed '20s/.*/v one two/' good.obj >bad.obj
says 'bad.obj:20: a vertex needs three numbers' mesh=bad.obj
sed '$d' good.obj >hole.obj
says 'inside the sheet' mesh=hole.obj
printf 'v %s 0\n' '0 0' '1 0' '1 1' '1 0' >twice.obj
echo 'f 1 2 3 4' >>twice.obj
says 'twice.obj:5: two triangles lie on the same side' mesh=twice.obj
says 'none.obj' mesh=none.obj
says 'refine: of a mesh that is no grid' refine=1
says 'arc=on: with bending=midedge only' mesh=irregular arc=on
says 'a mesh, or bending=midedge: with membrane=green or springs only' mesh=irregular membrane=corotational
# a napkin is folded on itself, within twice what is known of it, though no point lies where
# a grid has one
good run fold --model triangles --set discretization.mesh=irregular \
    --set 'discretization.points=[21,21,1]' --set time.end=0.15 --out fold.h5
good score fold fold.h5
grep -q 'Nothing wrong was found' out || fail "a fold on a mesh: $(<out)"

# projective dynamics on an irregular mesh comes as near the truth as on the grid
good run edge_drop --model projective_dynamics --set discretization.mesh=irregular \
    --set 'discretization.points=[16,16,1]' --set discretization.integrator=bdf2 \
    --set damping.kind=none --set time.step=0.0025 --set time.end=0.2 --out drop.h5
good score edge_drop drop.h5
grep -q 'Nothing wrong was found' out || fail "a drop on a mesh: $(<out)"

# the other nets know meshes, too, and what they can't do on one
for model in mass_spring position_based vbd projective_dynamics; do
    on_mesh=(run edge_drop --model "$model" --set time.end=0.01 --set 'snapshots=[]'
        --set discretization.mesh=good.obj)
    good "${on_mesh[@]}"
    ends 2 "${on_mesh[@]}" --set discretization.mesh=grid --set discretization.refine=1
    # a patch has edges at which nothing bends
    good run corners_patch --model "$model" --set time.end=0.01 --set 'snapshots=[]' \
        --set discretization.mesh=diagonal --set 'discretization.points=[11,11,1]'
done
refuses() { # SENTENCE MODEL SETTING
    ends 2 run edge_drop --model "$2" --set discretization.mesh=irregular --set "$3"
    grep -qF -- "$1" err || fail "$2 $3: does not say '$1': $(<err)"
}
refuses 'parameters=paper: of a grid only' mass_spring discretization.parameters=paper
refuses 'parameters=paper: of a grid only' projective_dynamics discretization.parameters=paper
refuses 'of an isotropic sheet only' position_based 'material={fabric: denim}'
refuses 'surface: of a grid only' mass_spring discretization.surface=cubic
refuses 'bending=hinge: of a grid only' vbd discretization.bending=hinge
exit $((failures > 0))
