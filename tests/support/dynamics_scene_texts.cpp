#include "tests/support/dynamics_scene_texts.hpp"

#include <array>
#include <stdexcept>
#include <string>

#include "lessons/read/reader.hpp"
#include "lessons/write/writer.hpp"

namespace jw::test {

namespace {

struct CourseTexts {
    std::string_view file;
    std::string_view summary;  ///< two lines
    std::string_view tables;   ///< [[question]] and [[try]], as in a lesson
};

constexpr std::array kTexts{
    CourseTexts{
        "simple-pendulum",
        R"(The ball falls as $(m l^2 + J) \ddot{\theta} = m g l \cos\theta$; the pin carries what is left of $m \ddot{\mathbf{r}} - m \mathbf{g}$.
Reactions do no work, so the energy is constant: whatever it changes by is the error of the integrator.)",
        R"(
[[question]]
at = "motion"
ask = '''The ball weighs 9.81 N and is released level with its pin. What does the pin carry when the ball is lowest, after 0.592 s, in N?'''
quantity = "pin.force.y"
at_s = 0.5922563931794198
tolerance = 0.3
why = '''From level to lowest, $m g l = \frac{1}{2} m v^2$. The pin carries $m g + m v^2 / l = 3 m g$, however long the rod is.'''

[[try]]
text = '''Keep all three equations of p1. One multiplier too many: the motion is the same, the multipliers are no longer unique.'''
do = ["form pin all three"]

[[try]]
text = '''Take out one of the two equations of p1. There is a second freedom now; only because nothing pushes it does the rod stay in its plane.'''
do = ["take out pin p1 x"]
breaks = true
)"},
    CourseTexts{
        "four-bar-1",
        R"(Three of the twenty equations are redundant, since the axes are parallel: their multipliers are not unique, the motion is.
In line the rank falls by one more; velocities carry the mechanism through, and energy tells whether it was carried well.)",
        R"(
[[question]]
at = "right 1"
ask = '''The last hinge closes the window with its five equations. How many of the twenty are redundant then?'''
count = "redundant"
why = '''Three. The other hinges already keep both ends in one plane and the axes parallel: what is new is only that the points meet in x and y.'''

[[question]]
at = "motion"
ask = '''The rods fall to the right and turn faster and faster. How fast does the coupler turn about z at $t = 1$ s, in rad/s?'''
quantity = "coupler.omega.z"
at_s = 1
tolerance_rad_per_s = 0.01
why = '''Not at all. Opposite sides are equal, the mechanism stays a parallelogram, and the coupler only translates.'''

[[try]]
text = '''Take out one equation of p1 of the last hinge. It is redundant: rank and motion stay.'''
do = ["take out right 1 p1 x"]

[[try]]
text = '''Take out the last hinge. The window opens, and coupler and rod swing as they like.'''
do = ["take out right 1"]
breaks = true
)"},
    CourseTexts{
        "four-bar-4",
        R"(Every window has three redundant equations, whatever their number: one freedom, $3 n$ equations too many.
The price of a step may grow with the number of bodies, not with its square or its cube.)",
        R"(
[[question]]
at = "right 4"
ask = '''Four windows stand side by side: 13 hinges, 65 equations for the 54 coordinates of 9 bodies. How many are redundant?'''
count = "redundant"
why = '''Three for each window, 12. Rank $65 - 12 = 53$ leaves one freedom.'''

[[try]]
text = '''Take out one equation of p1 in the middle. It is redundant: rank and motion stay.'''
do = ["take out right 2 p1 x"]

[[try]]
text = '''Take out the last hinge. The last coupler and the last rod swing as they like: two more freedoms.'''
do = ["take out right 4"]
breaks = true
)"},
    CourseTexts{
        "andrews",
        R"(In the plane 20 equations for 21 coordinates, in space 50 for 42: nine are redundant, and one freedom is left both times.
The angles at 30 ms are known to 16 digits: an integrator is judged by its error, not by how smooth its picture is.)",
        R"(
[[question]]
at = "E6"
ask = '''Seven bodies, ten hinges. What mobility does Grübler's count promise in space?'''
count = "mobility_by_counting"
why = '''$6 \cdot 7 - 5 \cdot 10 = -8$. There is one freedom all the same: nine equations are redundant, since all axes are parallel. In the plane, $3 \cdot 7 - 2 \cdot 10 = 1$.'''

[[question]]
at = "motion"
ask = '''The spring holds 1.436 J at the start, and 0.033 N m turn the crank by 15.88 rad in 30 ms. How large is the sum of all energies then, in J?'''
quantity = "energy.sum"
at_s = 0.03
tolerance = 0.02
why = '''$1.436 + 0.033 \cdot 15.88 = 1.960$ J: the motor does work, the spring and the joints only pass it on.'''

[[try]]
text = '''Take out one equation of p1 of the last hinge. It is redundant: rank and motion stay.'''
do = ["take out E6 p1 x"]

[[try]]
text = '''Take out the pin of the rocker on the ground. Two more freedoms, and the spring pulls the rocker away.'''
do = ["take out B"]
breaks = true
)"},
    CourseTexts{
        "bricard-falling",
        R"(Six hinges and five moving bodies: Grübler counts no freedom, there is one, and one equation is redundant at every pose.
With a redundant equation $\boldsymbol{\lambda}$ is not unique, but $\boldsymbol{\Phi}_{\mathbf{q}}^T \boldsymbol{\lambda}$ is: the motion does not depend on which equation is left out.)",
        R"(
[[question]]
at = "F"
ask = '''Five moving bodies, six hinges: $30 - 30 = 0$ freedoms by counting. How many has the ring?'''
count = "dof"
why = '''One. The axes lie along edges of a cube, and one of the 30 equations follows from the others.'''

[[try]]
text = '''Take out one equation of p1. Any one that follows from the others will do: rank 29 stays.'''
do = ["take out F p1 y"]

[[try]]
text = '''Open the ring at its last hinge: an open chain with five freedoms.'''
do = ["take out F"]
breaks = true
)"},
    CourseTexts{
        "governor",
        R"(A motion is stiff when its equations contain others that decay much faster: then stability, not accuracy, limits an explicit step.
An implicit method solves a system in every step, and needs some hundred steps here where an explicit one needs many thousands.)",
        R"(
[[question]]
at = "motion"
ask = '''The slider hangs on two springs of 800 000 N/m. With which acceleration along z does it start, in m/s²?'''
quantity = "slider.r_ddot.z"
at_s = 0
tolerance = 0.05
why = '''$-g$: the springs have their free length and the dampers do not move yet, so nothing holds the slider in the first instant.'''

[[try]]
text = '''Keep all three equations of the right pin: one multiplier too many, the same motion.'''
do = ["form right pin all three"]

[[try]]
text = '''Take out the right pin. The rod flies away on its spring.'''
do = ["take out right pin"]
breaks = true
)"},
    CourseTexts{
        "chain-revolute-4",
        R"(A tree has no redundant equations: each hinge brings five equations and leaves one freedom.
In the coordinates of its joints the chain has 4 equations instead of 24 and 20 multipliers, and each step costs as much as there are links.)",
        R"(
[[question]]
at = "motion"
ask = '''Rods 2 and 3 turn at 1 rad/s, all rods are level. How strongly does the first hinge pull at $t = 0$, along x and in N?'''
quantity = "hinge 1.force.x"
at_s = 0
tolerance = 0.1
why = '''Gravity has no part along x. Each middle moves inwards at $\sum \omega^2 l$ of the rods before it and $\omega^2 l / 2$ of its own: $0 + 0.5 + 1.5 + 2 = 4$ m/s², for 1 kg each.'''

[[try]]
text = '''Keep all three equations of the second hinge: a sixth equation that adds no rank.'''
do = ["form hinge 2 all three"]

[[try]]
text = '''Take out the third hinge. The last two rods fall freely: five more freedoms.'''
do = ["take out hinge 3"]
breaks = true
)"},
    CourseTexts{
        "chain-spherical-4",
        R"(Each ball leaves three freedoms, so four rods have twelve; nothing is redundant in a tree.
The twist of a rod about itself is a freedom that no weight moves: it costs a column, and nobody sees it.)",
        R"(
[[question]]
at = "ball 4"
ask = '''Four rods hang in a row on four balls. How many freedoms has the chain?'''
count = "dof"
why = '''$6 \cdot 4 - 3 \cdot 4 = 12$: three angles for each rod.'''

[[question]]
at = "motion"
ask = '''The level chain turns at 1 rad/s about y. How strongly does the first ball pull at $t = 0$, along x and in N?'''
quantity = "ball 1.force.x"
at_s = 0
tolerance = 0.1
why = '''$-m \omega^2 (0.5 + 1.5 + 2.5 + 3.5) = -8$ N, as for one rod of 4 m: $m \omega^2 r$ of its middle.'''

[[try]]
text = '''Show the same chain with Euler parameters: seven columns and a row $\mathbf{p}^T \mathbf{p} - 1$ for each rod. Freedoms and motion stay.'''
do = ["coordinates rp"]

[[try]]
text = '''Take out one of the three equations of the last ball. Its end slides along that direction: a freedom more.'''
do = ["take out ball 4 s x"]
breaks = true
)"},
    CourseTexts{
        "spatial-slider-crank-falling",
        R"($\boldsymbol{\lambda}$ has one number for each equation; forces and torques of the joints are $-\boldsymbol{\Phi}_{\mathbf{q}}^T \boldsymbol{\lambda}$, split by joint.
A joint exerts nothing along what it leaves free: no force along the rail, no torque about the shaft.)",
        R"(
[[question]]
at = "motion"
ask = '''Wheel and rod push the slide to and fro on its rail, which has no friction. What force does the rail exert on the slide along x at $t = 2$ s, in N?'''
quantity = "rail.force.x"
at_s = 2
tolerance = 0.01
why = '''None. The rail leaves x free, so no column of its $\boldsymbol{\Phi}_{\mathbf{q}}^T$ points along it.'''

[[try]]
text = '''Keep all three equations of p1 of the shaft: 18 equations, rank 17. Its torque is no longer unique in parts, the motion is the same.'''
do = ["form shaft all three"]

[[try]]
text = '''Take out the n1 equation of the cross. The joint is a ball now, and the rod may turn about itself: a freedom more.'''
do = ["take out cross n1"]
breaks = true
)"},
    CourseTexts{
        "spinning-top",
        R"(The torque of the weight is normal to the spin: it turns the angular momentum instead of increasing it, and the top precesses.
$\mathbf{J}' \dot{\boldsymbol{\omega}}' + \tilde{\boldsymbol{\omega}}' \mathbf{J}' \boldsymbol{\omega}' = \mathbf{n}'$: with $J_x = J_y$ and no torque about z, $\omega_z'$ is constant.)",
        R"(
[[question]]
at = "motion"
ask = '''The top starts with 150 rad/s about its own axis, nutates and precesses. Which $\omega_z'$ has it after 4 s, in rad/s?'''
quantity = "top.omega_local.z"
at_s = 4
tolerance_rad_per_s = 0.5
why = '''150: $J_z \dot{\omega}_z' = (J_x - J_y) \omega_x' \omega_y' + n_z'$. The first is zero for a symmetric top, the second because the weight acts on its axis.'''

[[try]]
text = '''Stand the top on a point closer to its centre of mass: the torque of the weight is smaller, and it precesses more slowly.'''
do = ["point tip j 0 0 -0.05"]

[[try]]
text = '''Take out the tip. The top falls, and its axis keeps its direction: nothing turns the angular momentum.'''
do = ["take out tip"]
breaks = true
)"},
    CourseTexts{
        "free-asymmetric-body",
        R"($\mathbf{J}' \dot{\boldsymbol{\omega}}' = -\tilde{\boldsymbol{\omega}}' \mathbf{J}' \boldsymbol{\omega}'$: about the axes of the largest and the smallest $J$ a turn is stable, about the one between it is not.
No force acts, so energy and angular momentum are constant; $\boldsymbol{\omega}'$ is not.)",
        R"(
[[question]]
at = "motion"
ask = '''The box turns at 6 rad/s about its y axis, and no torque acts. Which $\omega_y'$ has it after 4.09 s, in rad/s?'''
quantity = "box.omega_local.y"
at_s = 4.094782471218922
tolerance_rad_per_s = 0.3
why = '''$-6$: it has turned over. J about y is the middle one of the three, and a deviation of 0.02 rad/s grows as $e^{\lambda t}$ until it has.'''

[[try]]
text = '''The same equations for $\boldsymbol{\omega}$, in the global frame: the motion is the same, but M changes with the attitude.'''
do = ["coordinates omega-global"]
)"}};

}  // namespace

Lesson with_course_texts(const Lesson& scene, std::string_view file) {
    for (const CourseTexts& texts : kTexts) {
        if (texts.file != file) { continue; }
        Lesson lesson = scene;
        lesson.summary = std::string(texts.summary) + '\n';
        ReadResult read =
            read_lesson(lesson_text(lesson) + std::string(texts.tables), std::string(file) + ".toml");
        if (!read.lesson) { throw std::logic_error(read.report()); }
        return *std::move(read.lesson);
    }
    throw std::logic_error("no texts for " + std::string(file));
}

}  // namespace jw::test
