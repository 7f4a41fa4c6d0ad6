/* A molecule as Avogadro's library writes it for POV-Ray. Usage: with_avogadro > FILE.pov */
#include <avogadro/core/vector.h>
#include <avogadro/rendering/camera.h>
#include <avogadro/rendering/cylindergeometry.h>
#include <avogadro/rendering/povrayvisitor.h>
#include <avogadro/rendering/spheregeometry.h>
#include <iostream>

using namespace Avogadro;
using namespace Avogadro::Rendering;

int main()
{
    const Vector3f places[] = { { 0, 0, 0 }, { 1.2f, .4f, 0 }, { -1.1f, .5f, .2f }, { .1f, -1.2f, .4f } };
    Camera camera;
    camera.lookAt(Vector3f(0, 0, 4), Vector3f(0, 0, 0), Vector3f(0, 1, 0));
    POVRayVisitor writer(camera);
    writer.setBackgroundColor(Vector3ub(230, 230, 240));
    writer.setAmbientColor(Vector3ub(60, 60, 60));
    writer.setAspectRatio(4.0f / 3.0f);
    writer.begin();
    SphereGeometry atoms;
    CylinderGeometry bonds;
    for (int i = 0; i < 4; i++)
        atoms.addSphere(places[i], Vector3ub(200, 60 + 40 * i, 40), i ? .35f : .55f);
    for (int i = 1; i < 4; i++)
        bonds.addCylinder(places[0], places[i], .12f, Vector3ub(200, 60, 40), Vector3ub(200, 200, 40));
    atoms.accept(writer);
    bonds.accept(writer);
    std::cout << writer.end();
}
