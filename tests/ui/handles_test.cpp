// SPDX-License-Identifier: GPL-3.0-or-later
// What the mouse drags in a view besides the camera: objects by their handles, and lights.
#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <vector>

#include <QApplication>
#include <QTest>

#include <QPainter>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "docks/light_actions.h"
#include "document/scene_edits.h"
#include "render/lights/light_lists.h"
#include "scene/turntable.h"
#include "ui/window_fixture.h"
#include "viewport/light_handles.h"
#include "viewport/light_pose.h"
#include "viewport/ray_cast.h"
#include "viewport/side_view.h"

namespace patina::tests::handles_test {
namespace {

// Parts of a light that have handles, in the order of their numbers.
constexpr int targetHandle = 1;
constexpr int coneHandle = 3;
constexpr int partCount = 4;

class Handles : public WindowFixture {
  protected:
    Handles() { focusView(); }

    const Object& object() { return document().scene().objects[0]; }
    int steps() { return document().undoStack().count(); }
    glm::dvec2 size() { return {view().width(), view().height()}; }
    QPoint placeOf(const glm::dvec3& point) {
        const auto place = patina::placeOf(camera(), point, size());
        return {qRound(place->x), qRound(place->y)};
    }
    /// Where the end of a world axis of the handles is.
    QPoint endOf(const glm::dvec3& axis) {
        const glm::dvec3& origin = object().translation;
        return placeOf(origin + axis * (78.0 / pixelsPerMetre(camera(), origin, size().y)));
    }
    void key(Qt::Key key) { QTest::keyClick(&view(), key); }
    void press(QPoint at) { QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, at); }
    void moveTo(QPoint at) {
        QMouseEvent move(QEvent::MouseMove, at, view().mapToGlobal(at), Qt::NoButton,
                         Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&view(), &move);
    }
    void release(QPoint at) { QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, at); }
    void dragFrom(QPoint from, QPoint by) {
        press(from);
        moveTo(from + by / 2);
        moveTo(from + by);
        release(from + by);
    }
    LightPose pose(std::size_t index) {
        const Light& light = document().scene().lights[index];
        return *lightPose(light.block.parameters,
                          *document().catalog().find(kinds::lights, light.block.id), camera());
    }
    /// A spot light above the object, which is the current one.
    std::size_t addSpot() {
        const auto blocks = document().catalog().ofKind(kinds::lights);
        const auto spot = std::ranges::find_if(blocks, [](const Block* block) {
            return block->reach && !block->reach->angle.empty();
        });
        addLight(document(), (*spot)->id);
        const std::size_t index = document().scene().lights.size() - 1;
        document().selection().setLight(int(index));
        LightPose above = pose(index);
        above.point = {0.5, 0.95, 0.4};
        above.direction = glm::normalize(glm::dvec3(0.0) - above.point);
        document().setValues(pathOf(kinds::lights, int(index)), valuesAt(above, camera()), "place");
        newFrames();
        return index;
    }
    /// Where the handle of a part of the last light is seen, by its number among them.
    QPoint handleOf(int part) {
        const auto meshes = [this](const Object& each) { return window().meshes().pickMesh(each); };
        std::optional<std::optional<Hit>> onAxis; // a spot asks for that alone
        const LightHandles handles(document(), window().views().handleModes(), [&](const Ray& ray) {
            if (!onAxis) {
                onAxis = castWithGround(ray, document().scene(), eye(camera()), meshes);
            }
            return *onAxis;
        });
        const ViewGeometry geometry{camera(), size()};
        std::map<int, std::vector<QPoint>> found;
        for (int y = 0; y < view().height(); ++y) {
            for (int x = 0; x < view().width(); ++x) {
                if (const auto handle = handles.handleAt(geometry, QPointF(x, y))) {
                    found[*handle].push_back({x, y});
                }
            }
        }
        const std::vector<QPoint>& at = found[found.rbegin()->first / partCount * partCount + part];
        EXPECT_FALSE(at.empty()) << part;
        const QPoint sum = std::accumulate(at.begin(), at.end(), QPoint());
        return sum / std::max<int>(int(at.size()), 1);
    }
    QString undoText() { return document().undoStack().undoText(); }
    /// The axis of a light as it is seen.
    double axisAt(std::size_t light, const glm::dvec3& point) {
        return glm::dot(glm::normalize(point - pose(light).point), *pose(light).direction);
    }
};

TEST_F(Handles, LampOfADirectionalLight_StandsBesideTheObject) {
    const LightHandles handles(document(), window().views().handleModes(),
                               [](const Ray&) { return std::nullopt; });
    const ViewGeometry geometry{camera(), size()};
    const auto meshes = [this](const Object& each) { return window().meshes().pickMesh(each); };
    ASSERT_FALSE(pose(0).hasPoint());
    int found = 0;
    for (int y = 0; y < view().height(); y += 4) {
        for (int x = 0; x < view().width(); x += 4) {
            if (handles.handleAt(geometry, QPointF(x, y))) {
                ++found;
                EXPECT_FALSE(cast(geometry.ray(QPointF(x, y)), document().scene(), meshes))
                    << x << ", " << y;
            }
        }
    }
    EXPECT_GT(found, 0);
}

TEST_F(Handles, DragOfAnAxis_MovesAlongItInOneStep) {
    key(Qt::Key_W);
    const Camera before = camera();
    const QPoint end = endOf({0.0, 1.0, 0.0});
    dragFrom(end, {0, -40});
    EXPECT_GT(object().translation.y, 0.05);
    EXPECT_NEAR(object().translation.x, 0.0, 1e-9);
    EXPECT_NEAR(object().translation.z, 0.0, 1e-9);
    EXPECT_EQ(camera(), before);
    EXPECT_EQ(steps(), 1);
    EXPECT_EQ(document().undoStack().undoText(), "Move object");
}

TEST_F(Handles, DragOfTheMiddle_FollowsThePointer) {
    key(Qt::Key_W);
    const QPoint from = placeOf(object().translation);
    dragFrom(from, {40, 25});
    const QPoint there = placeOf(object().translation);
    EXPECT_NEAR(there.x(), from.x() + 40, 2);
    EXPECT_NEAR(there.y(), from.y() + 25, 2);
}

TEST_F(Handles, EscWhileDragged_PutsTheObjectBackWithoutAStep) {
    key(Qt::Key_W);
    const Object before = object();
    const QPoint end = endOf({0.0, 1.0, 0.0});
    press(end);
    moveTo(end + QPoint(0, -40));
    ASSERT_NE(object(), before);
    key(Qt::Key_Escape);
    moveTo(end + QPoint(0, -60));
    release(end);
    EXPECT_EQ(object(), before);
    EXPECT_EQ(steps(), 0);
}

TEST_F(Handles, DragOfARing_TurnsAboutItsAxis) {
    Camera above = camera();
    above.yaw = 0.0;
    above.pitch = 90.0; // the ring of the upright axis is a circle
    document().setCamera(above);
    key(Qt::Key_R);
    const QPoint middle = placeOf(object().translation);
    press(middle + QPoint(80, 0));
    moveTo(middle + QPoint(57, -57));
    release(middle + QPoint(57, -57));
    EXPECT_NEAR(object().rotation.y, 45.0, 1.5);
    EXPECT_NEAR(object().rotation.x, 0.0, 1e-3);
    EXPECT_EQ(steps(), 1);
}

TEST_F(Handles, DragOfTheMiddleOfScaling_ScalesAllAxes) {
    key(Qt::Key_S);
    dragFrom(placeOf(object().translation), {50, 0});
    EXPECT_GT(object().scale.x, 1.2);
    EXPECT_EQ(object().scale.x, object().scale.z);
    EXPECT_EQ(steps(), 1);
}

TEST_F(Handles, KeyOnceMore_HidesThem) {
    key(Qt::Key_W);
    key(Qt::Key_W);
    const Object before = object();
    dragFrom(endOf({0.0, 1.0, 0.0}), {0, -40});
    EXPECT_EQ(object(), before);
}

TEST_F(Handles, DragOfALamp_MovesItAsItIsSeen) {
    const std::size_t spot = addSpot();
    const int before = steps();
    const QPoint from = placeOf(pose(spot).point);
    dragFrom(from, {-30, 12});
    const QPoint there = placeOf(pose(spot).point);
    EXPECT_NEAR(there.x(), from.x() - 30, 2);
    EXPECT_NEAR(there.y(), from.y() + 12, 2);
    EXPECT_EQ(steps(), before + 1);
    EXPECT_EQ(undoText(), "Move light");
}

TEST_F(Handles, DragOfALampWithoutAPlace_TurnsTheLight) {
    document().selection().setLight(0);
    const LightPose before = pose(0);
    const int stepsBefore = steps();
    const LightHandles handles(document(), window().views().handleModes(),
                               [](const Ray&) { return std::nullopt; });
    const ViewGeometry geometry{camera(), size()};
    std::optional<QPoint> lamp;
    for (int y = 0; y < view().height() && !lamp; ++y) {
        for (int x = 0; x < view().width() && !lamp; ++x) {
            const auto found = handles.handleAt(geometry, QPointF(x, y));
            lamp = found && *found < partCount ? std::optional(QPoint(x, y)) : std::nullopt;
        }
    }
    ASSERT_TRUE(lamp);
    dragFrom(*lamp, {50, 0});
    // 0.4 degrees per pixel about the vertical
    const glm::dvec3 expected = turnedAbout(*before.direction, {0.0, 1.0, 0.0}, 20.0);
    EXPECT_NEAR(glm::distance(*pose(0).direction, expected), 0.0, 1e-6);
    EXPECT_EQ(steps(), stepsBefore + 1);
    EXPECT_EQ(undoText(), "Turn light");
}

TEST_F(Handles, DragOfALampsTarget_AimsItAtWhatIsUnderThePointer) {
    const std::size_t spot = addSpot();
    const LightPose before = pose(spot);
    const int stepsBefore = steps();
    const QPoint from = handleOf(targetHandle);
    const QPoint to = placeOf({0.1, -0.05, 0.2});
    const auto meshes = [this](const Object& each) { return window().meshes().pickMesh(each); };
    const auto hit = cast(ViewGeometry{camera(), size()}.ray(to), document().scene(), meshes);
    ASSERT_TRUE(hit);
    ASSERT_LT(axisAt(spot, hit->point), 0.999);
    dragFrom(from, to - from);
    EXPECT_GT(axisAt(spot, hit->point), 1.0 - 1e-6);
    EXPECT_EQ(pose(spot).point, before.point);
    EXPECT_EQ(pose(spot).angle, before.angle);
    EXPECT_EQ(steps(), stepsBefore + 1);
    EXPECT_EQ(undoText(), "Aim light");
}

TEST_F(Handles, DragOfALampsCone_MakesItAsWideAsThePointerIsFromItsAxis) {
    const std::size_t spot = addSpot();
    const LightPose before = pose(spot);
    const int stepsBefore = steps();
    const QPoint handle = handleOf(coneHandle);
    const QPointF tip = placeOf(before.point);
    const QPointF axis = placeOf(before.point + *before.direction) - tip;
    const QPointF fromTip = handle - tip;
    const QPointF along =
        axis * QPointF::dotProduct(fromTip, axis) / QPointF::dotProduct(axis, axis);
    const QPoint outwards = ((fromTip - along) * 0.5).toPoint();
    ASSERT_GT(outwards.manhattanLength(), 3) << "the cone is seen from the side";
    dragFrom(handle, outwards);
    const LightPose wider = pose(spot);
    EXPECT_GT(wider.angle, 1.1 * before.angle);
    EXPECT_LT(wider.angle, 2.0 * before.angle);
    EXPECT_EQ(wider.point, before.point);
    EXPECT_EQ(*wider.direction, *before.direction);
    EXPECT_EQ(steps(), stepsBefore + 1);
    EXPECT_EQ(undoText(), "Change cone of light");
    document().undoStack().undo();
    dragFrom(handle, along.toPoint() / 10); // away from the tip, along the side
    EXPECT_NEAR(pose(spot).angle, before.angle, 0.2 * before.angle);
    document().undoStack().undo();
    EXPECT_EQ(pose(spot).angle, before.angle);
}

TEST_F(Handles, EscWhileALampIsDragged_PutsItBackWithoutAStep) {
    const std::size_t spot = addSpot();
    const std::vector<Light> before = document().scene().lights;
    const int stepsBefore = steps();
    const QPoint from = placeOf(pose(spot).point);
    press(from);
    moveTo(from + QPoint(-30, 12));
    ASSERT_NE(document().scene().lights, before);
    key(Qt::Key_Escape);
    release(from);
    EXPECT_EQ(document().scene().lights, before);
    EXPECT_EQ(steps(), stepsBefore);
}

TEST_F(Handles, DragOfALampsDistance_MovesItAlongItsAxis) {
    const std::size_t spot = addSpot();
    const LightPose before = pose(spot);
    const Ray axis{before.point, *before.direction};
    const auto meshes = [this](const Object& each) { return window().meshes().pickMesh(each); };
    const auto target = cast(axis, document().scene(), meshes);
    ASSERT_TRUE(target);
    const QPoint handle = placeOf(glm::mix(before.point, target->point, 0.45));
    dragFrom(handle, placeOf(before.point) - handle);
    EXPECT_GT(glm::distance(pose(spot).point, target->point), 1.2 * target->distance);
    EXPECT_NEAR(glm::distance(*pose(spot).direction, *before.direction), 0.0, 1e-6);
    EXPECT_EQ(pose(spot).angle, before.angle);
    EXPECT_EQ(undoText(), "Change distance of light");
}

/// A new spot light stands above the view: its lamp is seen at the edge and follows the pointer
/// from there.
TEST_F(Handles, LampBesideTheView_IsPulledInFromItsEdge) {
    const std::size_t spot = addSpot();
    LightPose above = pose(spot);
    above.point = {2.0, 3.0, 2.0};
    above.direction = glm::normalize(-above.point);
    document().setValues(pathOf(kinds::lights, int(spot)), valuesAt(above, camera()), "place");
    newFrames();
    ASSERT_LT(placeOf(above.point).y(), 0);
    const LightHandles handles(document(), window().views().handleModes(),
                               [](const Ray&) { return std::nullopt; });
    const ViewGeometry geometry{camera(), size()};
    std::optional<QPoint> lamp;
    for (int x = 0; x < view().width() && !lamp; ++x) {
        lamp = handles.handleAt(geometry, QPointF(x, 22)) ? std::optional(QPoint(x, 22)) : lamp;
    }
    ASSERT_TRUE(lamp);
    dragFrom(*lamp, {-30, 60});
    const QPoint there = placeOf(pose(spot).point);
    EXPECT_NEAR(there.x(), lamp->x() - 30, 10); // within the lamp's reach
    EXPECT_NEAR(there.y(), lamp->y() + 60, 10);
}

/// The spot stands where the directional light shone from, so far away that its cone holds the
/// object.
TEST_F(Handles, DirectionalLightMadeASpot_LightsTheObjectInOneStep) {
    document().selection().setLight(0);
    const LightPose before = pose(0);
    ASSERT_FALSE(before.hasPoint());
    setKindOfLight(document(), window().meshes(), "spot");
    const LightPose spot = pose(0);
    ASSERT_TRUE(spot.hasPoint() && spot.direction && spot.angleOf);
    const Bounds bounds = window().meshes().view(object()).bounds;
    const Ball ball = ballAround(bounds, worldMatrix(object()));
    const glm::dvec3 way = ball.center - spot.point;
    EXPECT_GT(glm::dot(glm::normalize(way), *before.direction), 0.999);
    EXPECT_GT(glm::dot(glm::normalize(way), *spot.direction), 0.999);
    EXPECT_GT(glm::length(way) * std::sin(glm::radians(spot.angle)), 0.98 * ball.radius);
    EXPECT_EQ(steps(), 1);
    document().undoStack().undo();
    EXPECT_EQ(pose(0).point, before.point);
    EXPECT_FALSE(pose(0).hasPoint());
}

TEST_F(Handles, SpotMadeDirectionalAndBack_StandsWhereItStood) {
    document().selection().setLight(0);
    setKindOfLight(document(), window().meshes(), "spot");
    const glm::dvec3 placed = pose(0).point + glm::dvec3(0.0, 0.05, 0.0);
    document().setValues(pathOf(kinds::lights, 0), {{pose(0).pointOf->id, placed}}, "place");
    setKindOfLight(document(), window().meshes(), "directional");
    setKindOfLight(document(), window().meshes(), "spot");
    EXPECT_LT(glm::distance(pose(0).point, placed), 1e-5);
}

/// Its direction is new: without one it shone everywhere.
TEST_F(Handles, PointLightMadeASpot_IsAimedAtTheObject) {
    document().selection().setLight(0);
    setKindOfLight(document(), window().meshes(), "point");
    const glm::dvec3 placed(-1.0, 2.0, 3.0);
    document().setValues(pathOf(kinds::lights, 0), {{pose(0).pointOf->id, placed}}, "place");
    setKindOfLight(document(), window().meshes(), "spot");
    EXPECT_EQ(pose(0).point, placed);
    EXPECT_GT(glm::dot(*pose(0).direction, glm::normalize(object().translation - placed)), 0.98);
}

TEST_F(Handles, LinesOfAWhiteLight_AreSeenOnWhite) {
    const std::size_t index = addSpot();
    const LightHandles handles(document(), window().views().handleModes(),
                               [](const Ray&) { return std::nullopt; });
    QImage white(view().size(), QImage::Format_RGB32);
    white.fill(Qt::white);
    const ViewGeometry geometry{camera(), size()};
    QPainter painter(&white);
    handles.draw(geometry, painter, std::nullopt);
    painter.end();
    // A quarter of the way to the target there is nothing but the line.
    const glm::dvec3 from = pose(index).point;
    const glm::dvec3 at = glm::mix(from, glm::dvec3(0.0), 0.25);
    const QPoint place = placeOf(at);
    int dark = 0;
    for (int y = -3; y <= 3; ++y) {
        for (int x = -3; x <= 3; ++x) {
            dark += white.pixelColor(place + QPoint(x, y)).lightness() < 190 ? 1 : 0;
        }
    }
    EXPECT_GT(dark, 3);
}

TEST_F(Handles, LightsThatAreNotShown_AreNotDragged) {
    const std::size_t spot = addSpot();
    window().views().handleModes().setShowsLights(false);
    const LightPose before = pose(spot);
    dragFrom(placeOf(before.point), {-30, 12});
    EXPECT_EQ(pose(spot).point, before.point);
}

TEST_F(Handles, LAndClick_PutTheHighlightUnderThePointer) {
    const std::size_t spot = addSpot();
    const int before = steps();
    const QPoint place = view().rect().center() + QPoint(20, 12);
    QTest::keyPress(&view(), Qt::Key_L);
    QTest::mouseClick(&view(), Qt::LeftButton, Qt::NoModifier, place);
    QTest::keyRelease(&view(), Qt::Key_L);
    const auto meshes = [this](const Object& each) { return window().meshes().pickMesh(each); };
    const auto hit =
        cast(rayThrough(camera(), {place.x(), place.y()}, size()), document().scene(), meshes);
    ASSERT_TRUE(hit);
    const glm::dvec3 toLight = glm::normalize(pose(spot).point - hit->point);
    const glm::dvec3 toEye = glm::normalize(eye(camera()) - hit->point);
    EXPECT_NEAR(glm::dot(glm::normalize(toLight + toEye), hit->normal), 1.0, 1e-6);
    EXPECT_NEAR(glm::dot(*pose(spot).direction, -toLight), 1.0, 1e-6);
    EXPECT_EQ(steps(), before + 1);
}

TEST_F(Handles, LShiftAndClick_PutTheShadowUnderThePointer) {
    Object floor;
    floor.mesh = "builtin:cube";
    floor.translation = {0.0, -1.6, 0.0};
    floor.scale = {4.0, 0.5, 4.0};
    floor.material = object().material;
    addObject(document(), floor);
    document().selection().setObject(0);
    const std::size_t spot = addSpot();
    const QPoint place = placeOf({1.5, -1.1, 1.0});
    QTest::keyPress(&view(), Qt::Key_L);
    QTest::mouseClick(&view(), Qt::LeftButton, Qt::ShiftModifier, place);
    QTest::keyRelease(&view(), Qt::Key_L);
    const auto meshes = [this](const Object& each) { return window().meshes().pickMesh(each); };
    const auto hit =
        cast(rayThrough(camera(), {place.x(), place.y()}, size()), document().scene(), meshes);
    ASSERT_TRUE(hit);
    ASSERT_EQ(hit->object, 1);
    const auto met = cast({pose(spot).point, *pose(spot).direction}, document().scene(), meshes);
    ASSERT_TRUE(met);
    EXPECT_EQ(met->object, 0); // the caster is between the light and the place
}

/// The ground is no object, but shadows fall on it.
TEST_F(Handles, ShadowPutOnTheGround_FallsThere) {
    document().setValue(document().selection().currentPath(settings::scene), "ground.mode",
                        std::string("plane"));
    document().selection().setObject(0);
    const std::size_t spot = addSpot();
    window().views().active().awaitLightPick(true);
    const QPoint place(view().width() - 30, view().height() - 30);
    QTest::mouseClick(&view(), Qt::LeftButton, Qt::NoModifier, place);
    const Ray way{pose(spot).point, *pose(spot).direction};
    const auto meshes = [this](const Object& each) { return window().meshes().pickMesh(each); };
    EXPECT_TRUE(cast(way, document().scene(), meshes)); // the caster is on the way
    const Ray seen = rayThrough(camera(), {place.x(), place.y()}, size());
    ASSERT_FALSE(cast(seen, document().scene(), meshes));
    const auto ground = castWithGround(seen, document().scene(), eye(camera()), meshes);
    ASSERT_TRUE(ground);
    EXPECT_EQ(ground->object, -1);
    EXPECT_NEAR(glm::length(glm::cross(ground->point - way.origin, way.direction)), 0.0, 1e-6);
}

TEST_F(Handles, EscBeforeTheClick_LeavesTheLight) {
    const std::size_t spot = addSpot();
    const LightPose before = pose(spot);
    window().views().active().awaitLightPick(false);
    key(Qt::Key_Escape);
    QTest::mouseClick(&view(), Qt::LeftButton, Qt::NoModifier, view().rect().center());
    EXPECT_EQ(pose(spot).point, before.point);
}

TEST_F(Handles, SoloTwice_LeavesTheLightsAsTheyWere) {
    toggleMute(document(), 1);
    const std::vector<Light> before = document().scene().lights;
    toggleSolo(document(), 0);
    EXPECT_EQ(std::ranges::count(document().scene().lights, true, &Light::enabled), 1);
    toggleSolo(document(), 2);
    EXPECT_TRUE(document().scene().lights[2].enabled);
    EXPECT_EQ(std::ranges::count(document().scene().lights, true, &Light::enabled), 1);
    toggleSolo(document(), 2);
    EXPECT_EQ(document().scene().lights, before);
}

} // namespace
} // namespace patina::tests::handles_test
