struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_13 {
member: array<f32>,
}
struct type_17 {
member: u32,
member_1: u32,
}
struct type_18 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
}
struct type_20 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
}
struct type_21 {
member: f32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
}
struct type_22 {
member: type_2,
member_1: type_17,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_18,
member_12: type_19,
member_13: type_20,
member_14: type_9,
member_15: type_6,
member_16: type_5,
member_17: u32,
member_18: type_21,
}
struct type_23 {
member: type_22,
}
struct type_24 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
}
struct type_26 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: f32,
member_5: bool,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_23;
@group(0) @binding(1)
var<storage> global_2: type_13;
@group(0) @binding(2)
var<storage> global_3: type_13;
@group(0) @binding(3)
var<storage> global_4: type_13;
@group(0) @binding(7)
var<storage, read_write> global_5: type_13;
@group(0) @binding(4)
var<storage> global_6: type_13;
@group(0) @binding(5)
var<storage> global_7: type_13;
@group(0) @binding(6)
var<storage> global_8: type_13;
fn function_() {
var local: f32;
var local_1: i32;
var local_2: f32;
var local_3: i32;
var local_4: f32;
var local_5: i32;
var local_6: f32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var local_10: i32;
var local_11: u32;
var local_12: type_17;
var local_13: u32;
var local_14: type_24;
var local_15: i32;
var local_16: i32;
var phi_2414_: type_26;
var phi_2478_: bool;
var phi_2510_: f32;
var phi_2551_: vec3<f32>;
var phi_2554_: u32;
var phi_2574_: u32;
var phi_2575_: u32;
var phi_2587_: u32;
var phi_2588_: u32;
var local_17: u32;
var local_18: u32;
var phi_2605_: u32;
var phi_2606_: u32;
var phi_2618_: u32;
var phi_2619_: u32;
var local_19: u32;
var local_20: u32;
var local_21: u32;
var phi_2644_: u32;
var phi_2645_: u32;
var local_22: u32;
var local_23: u32;
var phi_2662_: u32;
var phi_2663_: u32;
var local_24: u32;
var local_25: u32;
var phi_2685_: u32;
var phi_2686_: u32;
var phi_2698_: u32;
var phi_2699_: u32;
var local_26: u32;
var local_27: u32;
var local_28: u32;
var phi_2735_: u32;
var local_29: u32;
var phi_2748_: vec3<f32>;
var phi_2751_: type_17;
var phi_4205_: u32;
var phi_4208_: f32;
var phi_4343_: i32;
var phi_4356_: i32;
var phi_4370_: i32;
var phi_4686_: i32;
var phi_4699_: i32;
var phi_4713_: i32;
var phi_4206_: u32;
var phi_4209_: f32;
var phi_4918_: f32;
var phi_5251_: vec3<f32>;
var phi_5252_: vec3<f32>;
var phi_5253_: bool;
var phi_5257_: vec3<f32>;
var phi_5258_: bool;
var phi_5262_: vec3<f32>;
var phi_5263_: bool;
var phi_5279_: vec3<f32>;
var phi_5287_: type_17;
var phi_5288_: type_17;
var phi_5309_: vec3<f32>;
var phi_5310_: type_17;
var phi_2749_: vec3<f32>;
var phi_2752_: type_17;
var phi_2552_: vec3<f32>;
var phi_2555_: u32;
var phi_5459_: u32;
var phi_5462_: f32;
var phi_5597_: i32;
var phi_5610_: i32;
var phi_5624_: i32;
var phi_5940_: i32;
var phi_5953_: i32;
var phi_5967_: i32;
var phi_5460_: u32;
var phi_5463_: f32;
var phi_6172_: f32;
var local_30: vec3<f32>;
var local_31: vec3<f32>;
var local_32: vec3<f32>;
var phi_6408_: array<f32, 19>;
var local_33: f32;
var local_34: type_17;
var local_35: vec3<f32>;
var local_36: f32;
let _e127 = global;
let _e138 = arrayLength((&global_6.member));
let _e148 = global_1.member.member;
if (_e127.x < _e148.member) {
if (_e127.y < _e148.member_1) {
let _e155 = (_e148.member * _e148.member_1);
let _e157 = ((_e127.y * _e148.member) + _e127.x);
let _e158 = bitcast<i32>(_e157);
let _e160 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e162 = select(_e160, _e158, (_e158 < _e160));
let _e168 = global_5.member[bitcast<u32>(select(0i, _e162, (_e162 > 0i)))];
let _e169 = (_e155 + _e157);
let _e170 = bitcast<i32>(_e169);
let _e172 = select(_e160, _e170, (_e170 < _e160));
let _e178 = global_5.member[bitcast<u32>(select(0i, _e172, (_e172 > 0i)))];
let _e180 = ((2u * _e155) + _e157);
let _e181 = bitcast<i32>(_e180);
let _e183 = select(_e160, _e181, (_e181 < _e160));
let _e189 = global_5.member[bitcast<u32>(select(0i, _e183, (_e183 > 0i)))];
let _e191 = ((3u * _e155) + _e157);
let _e192 = bitcast<i32>(_e191);
let _e194 = select(_e160, _e192, (_e192 < _e160));
let _e200 = global_5.member[bitcast<u32>(select(0i, _e194, (_e194 > 0i)))];
let _e202 = ((4u * _e155) + _e157);
let _e203 = bitcast<i32>(_e202);
let _e205 = select(_e160, _e203, (_e203 < _e160));
let _e211 = global_5.member[bitcast<u32>(select(0i, _e205, (_e205 > 0i)))];
let _e213 = ((5u * _e155) + _e157);
let _e214 = bitcast<i32>(_e213);
let _e216 = select(_e160, _e214, (_e214 < _e160));
let _e222 = global_5.member[bitcast<u32>(select(0i, _e216, (_e216 > 0i)))];
let _e224 = ((6u * _e155) + _e157);
let _e225 = bitcast<i32>(_e224);
let _e227 = select(_e160, _e225, (_e225 < _e160));
let _e233 = global_5.member[bitcast<u32>(select(0i, _e227, (_e227 > 0i)))];
let _e235 = ((7u * _e155) + _e157);
let _e236 = bitcast<i32>(_e235);
let _e238 = select(_e160, _e236, (_e236 < _e160));
let _e244 = global_5.member[bitcast<u32>(select(0i, _e238, (_e238 > 0i)))];
let _e246 = ((8u * _e155) + _e157);
let _e247 = bitcast<i32>(_e246);
let _e249 = select(_e160, _e247, (_e247 < _e160));
let _e255 = global_5.member[bitcast<u32>(select(0i, _e249, (_e249 > 0i)))];
let _e257 = ((9u * _e155) + _e157);
let _e258 = bitcast<i32>(_e257);
let _e260 = select(_e160, _e258, (_e258 < _e160));
let _e266 = global_5.member[bitcast<u32>(select(0i, _e260, (_e260 > 0i)))];
let _e268 = ((10u * _e155) + _e157);
let _e269 = bitcast<i32>(_e268);
let _e271 = select(_e160, _e269, (_e269 < _e160));
let _e277 = global_5.member[bitcast<u32>(select(0i, _e271, (_e271 > 0i)))];
let _e279 = ((11u * _e155) + _e157);
let _e280 = bitcast<i32>(_e279);
let _e282 = select(_e160, _e280, (_e280 < _e160));
let _e288 = global_5.member[bitcast<u32>(select(0i, _e282, (_e282 > 0i)))];
let _e290 = ((12u * _e155) + _e157);
let _e291 = bitcast<i32>(_e290);
let _e293 = select(_e160, _e291, (_e291 < _e160));
let _e299 = global_5.member[bitcast<u32>(select(0i, _e293, (_e293 > 0i)))];
let _e301 = ((13u * _e155) + _e157);
let _e302 = bitcast<i32>(_e301);
let _e304 = select(_e160, _e302, (_e302 < _e160));
let _e310 = global_5.member[bitcast<u32>(select(0i, _e304, (_e304 > 0i)))];
let _e312 = ((14u * _e155) + _e157);
let _e313 = bitcast<i32>(_e312);
let _e315 = select(_e160, _e313, (_e313 < _e160));
let _e321 = global_5.member[bitcast<u32>(select(0i, _e315, (_e315 > 0i)))];
let _e323 = ((15u * _e155) + _e157);
let _e324 = bitcast<i32>(_e323);
let _e326 = select(_e160, _e324, (_e324 < _e160));
let _e332 = global_5.member[bitcast<u32>(select(0i, _e326, (_e326 > 0i)))];
let _e334 = ((16u * _e155) + _e157);
let _e335 = bitcast<i32>(_e334);
let _e337 = select(_e160, _e335, (_e335 < _e160));
let _e343 = global_5.member[bitcast<u32>(select(0i, _e337, (_e337 > 0i)))];
let _e345 = ((17u * _e155) + _e157);
let _e346 = bitcast<i32>(_e345);
let _e348 = select(_e160, _e346, (_e346 < _e160));
let _e354 = global_5.member[bitcast<u32>(select(0i, _e348, (_e348 > 0i)))];
let _e356 = ((18u * _e155) + _e157);
let _e357 = bitcast<i32>(_e356);
let _e359 = select(_e160, _e357, (_e357 < _e160));
let _e365 = global_5.member[bitcast<u32>(select(0i, _e359, (_e359 > 0i)))];
let _e370 = global_1.member.member.member;
let _e374 = global_1.member.member.member_1;
let _e375 = (_e370 * _e374);
local_15 = bitcast<i32>(_e375);
let _e378 = ((_e127.y * _e370) + _e127.x);
let _e379 = bitcast<i32>(_e378);
local_16 = _e379;
let _e380 = local_15;
let _e382 = local_16;
let _e383 = ((29i * _e380) + _e382);
let _e385 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e387 = select(_e385, _e383, (_e383 < _e385));
let _e392 = global_2.member[bitcast<u32>(select(0i, _e387, (_e387 > 0i)))];
let _e394 = local_15;
let _e396 = local_16;
let _e397 = ((36i * _e394) + _e396);
let _e399 = select(_e385, _e397, (_e397 < _e385));
let _e404 = global_2.member[bitcast<u32>(select(0i, _e399, (_e399 > 0i)))];
let _e415 = global_1.member.member_12.member_4;
if (select(0u, 3u, ((_e392 == 2f) && (select(0i, select(select(i32(_e404), i32(-2147483648), (_e404 < -2147483600f)), 2147483647i, (_e404 > 2147483500f)), (_e404 == _e404)) == (bitcast<i32>(_e415) + 1i)))) > 1u) {
let _e423 = select(_e385, _e379, (_e379 < _e385));
let _e429 = global_2.member[bitcast<u32>(select(0i, _e423, (_e423 > 0i)))];
let _e431 = bitcast<i32>((_e375 + _e378));
let _e433 = select(_e385, _e431, (_e431 < _e385));
let _e439 = global_2.member[bitcast<u32>(select(0i, _e433, (_e433 > 0i)))];
let _e442 = bitcast<i32>(((2u * _e375) + _e378));
let _e444 = select(_e385, _e442, (_e442 < _e385));
let _e450 = global_2.member[bitcast<u32>(select(0i, _e444, (_e444 > 0i)))];
let _e453 = bitcast<i32>(((3u * _e375) + _e378));
let _e455 = select(_e385, _e453, (_e453 < _e385));
let _e461 = global_2.member[bitcast<u32>(select(0i, _e455, (_e455 > 0i)))];
let _e464 = bitcast<i32>(((4u * _e375) + _e378));
let _e466 = select(_e385, _e464, (_e464 < _e385));
let _e472 = global_2.member[bitcast<u32>(select(0i, _e466, (_e466 > 0i)))];
let _e475 = bitcast<i32>(((5u * _e375) + _e378));
let _e477 = select(_e385, _e475, (_e475 < _e385));
let _e483 = global_2.member[bitcast<u32>(select(0i, _e477, (_e477 > 0i)))];
let _e486 = bitcast<i32>(((6u * _e375) + _e378));
let _e488 = select(_e385, _e486, (_e486 < _e385));
let _e494 = global_2.member[bitcast<u32>(select(0i, _e488, (_e488 > 0i)))];
let _e497 = bitcast<i32>(((7u * _e375) + _e378));
let _e499 = select(_e385, _e497, (_e497 < _e385));
let _e505 = global_2.member[bitcast<u32>(select(0i, _e499, (_e499 > 0i)))];
let _e508 = bitcast<i32>(((8u * _e375) + _e378));
let _e510 = select(_e385, _e508, (_e508 < _e385));
let _e516 = global_2.member[bitcast<u32>(select(0i, _e510, (_e510 > 0i)))];
let _e519 = bitcast<i32>(((9u * _e375) + _e378));
let _e521 = select(_e385, _e519, (_e519 < _e385));
let _e527 = global_2.member[bitcast<u32>(select(0i, _e521, (_e521 > 0i)))];
let _e530 = bitcast<i32>(((10u * _e375) + _e378));
let _e532 = select(_e385, _e530, (_e530 < _e385));
let _e538 = global_2.member[bitcast<u32>(select(0i, _e532, (_e532 > 0i)))];
let _e541 = bitcast<i32>(((11u * _e375) + _e378));
let _e543 = select(_e385, _e541, (_e541 < _e385));
let _e549 = global_2.member[bitcast<u32>(select(0i, _e543, (_e543 > 0i)))];
let _e552 = bitcast<i32>(((12u * _e375) + _e378));
let _e554 = select(_e385, _e552, (_e552 < _e385));
let _e560 = global_2.member[bitcast<u32>(select(0i, _e554, (_e554 > 0i)))];
let _e563 = bitcast<i32>(((13u * _e375) + _e378));
let _e565 = select(_e385, _e563, (_e563 < _e385));
let _e571 = global_2.member[bitcast<u32>(select(0i, _e565, (_e565 > 0i)))];
let _e574 = bitcast<i32>(((14u * _e375) + _e378));
let _e576 = select(_e385, _e574, (_e574 < _e385));
let _e582 = global_2.member[bitcast<u32>(select(0i, _e576, (_e576 > 0i)))];
let _e585 = bitcast<i32>(((15u * _e375) + _e378));
let _e587 = select(_e385, _e585, (_e585 < _e385));
let _e593 = global_2.member[bitcast<u32>(select(0i, _e587, (_e587 > 0i)))];
let _e596 = bitcast<i32>(((16u * _e375) + _e378));
let _e598 = select(_e385, _e596, (_e596 < _e385));
let _e604 = global_2.member[bitcast<u32>(select(0i, _e598, (_e598 > 0i)))];
let _e607 = bitcast<i32>(((17u * _e375) + _e378));
let _e609 = select(_e385, _e607, (_e607 < _e385));
let _e615 = global_2.member[bitcast<u32>(select(0i, _e609, (_e609 > 0i)))];
let _e618 = bitcast<i32>(((18u * _e375) + _e378));
let _e620 = select(_e385, _e618, (_e618 < _e385));
let _e626 = global_2.member[bitcast<u32>(select(0i, _e620, (_e620 > 0i)))];
let _e629 = bitcast<i32>(((19u * _e375) + _e378));
let _e631 = select(_e385, _e629, (_e629 < _e385));
let _e637 = global_2.member[bitcast<u32>(select(0i, _e631, (_e631 > 0i)))];
let _e640 = bitcast<i32>(((20u * _e375) + _e378));
let _e642 = select(_e385, _e640, (_e640 < _e385));
let _e648 = global_2.member[bitcast<u32>(select(0i, _e642, (_e642 > 0i)))];
let _e651 = bitcast<i32>(((23u * _e375) + _e378));
let _e653 = select(_e385, _e651, (_e651 < _e385));
let _e659 = global_2.member[bitcast<u32>(select(0i, _e653, (_e653 > 0i)))];
let _e662 = bitcast<i32>(((24u * _e375) + _e378));
let _e664 = select(_e385, _e662, (_e662 < _e385));
let _e670 = global_2.member[bitcast<u32>(select(0i, _e664, (_e664 > 0i)))];
let _e673 = bitcast<i32>(((30u * _e375) + _e378));
let _e675 = select(_e385, _e673, (_e673 < _e385));
let _e681 = global_2.member[bitcast<u32>(select(0i, _e675, (_e675 > 0i)))];
let _e688 = select(0i, select(select(i32(_e659), i32(-2147483648), (_e659 < -2147483600f)), 2147483647i, (_e659 > 2147483500f)), (_e659 == _e659));
let _e696 = (select(0i, select(select(i32(_e681), i32(-2147483648), (_e681 < -2147483600f)), 2147483647i, (_e681 > 2147483500f)), (_e681 == _e681)) == 0i);
let _e704 = global_1.member.member_1.member;
let _e710 = global_1.member.member_1.member_1;
let _e720 = global_1.member.member_2.member;
let _e721 = (((((f32(bitcast<i32>(_e127.x)) + 0.5f) / f32(bitcast<i32>(_e704))) * 2f) - 1f) * _e720);
let _e729 = global_1.member.member_2.member_1;
let _e730 = ((1f - (((f32(bitcast<i32>(_e127.y)) + 0.5f) / f32(bitcast<i32>(_e710))) * 2f)) * _e729);
let _e733 = global_1.member.member_3;
let _e742 = global_1.member.member_4;
let _e755 = global_1.member.member_2.member_3;
let _e756 = (_e755 != 0u);
let _e759 = global_1.member.member_6;
let _e766 = select(_e759.member, (_e759.member + ((_e733.member * _e721) + (_e742.member * _e730))), _e756);
let _e767 = select(_e759.member_1, (_e759.member_1 + ((_e733.member_1 * _e721) + (_e742.member_1 * _e730))), _e756);
let _e768 = select(_e759.member_2, (_e759.member_2 + ((_e733.member_2 * _e721) + (_e742.member_2 * _e730))), _e756);
let _e778 = select(_e429, _e766, _e696);
let _e779 = select(_e439, _e767, _e696);
let _e780 = select(_e450, _e768, _e696);
let _e781 = (select(0f, ((((_e429 - _e766) * _e461) + ((_e439 - _e767) * _e472)) + ((_e450 - _e768) * _e483)), _e696) + _e670);
let _e786 = select(_e781, 0f, (_e688 == -1i));
let _e790 = (_e778 + (_e461 * _e786));
let _e791 = (_e779 + (_e472 * _e786));
let _e792 = (_e780 + (_e483 * _e786));
let _e793 = vec3<f32>(_e790, _e791, _e792);
let _e796 = global_1.member.member_17;
let _e799 = (_e688 >= 0i);
if _e799 {
let _e844 = (_e688 * 19i);
let _e846 = (bitcast<i32>(_e138) - 1i);
let _e848 = select(_e846, _e844, (_e844 < _e846));
let _e854 = global_6.member[bitcast<u32>(select(0i, _e848, (_e848 > 0i)))];
let _e855 = (_e844 + 1i);
let _e857 = select(_e846, _e855, (_e855 < _e846));
let _e863 = global_6.member[bitcast<u32>(select(0i, _e857, (_e857 > 0i)))];
let _e864 = (_e844 + 2i);
let _e866 = select(_e846, _e864, (_e864 < _e846));
let _e872 = global_6.member[bitcast<u32>(select(0i, _e866, (_e866 > 0i)))];
let _e873 = (_e844 + 3i);
let _e875 = select(_e846, _e873, (_e873 < _e846));
let _e881 = global_6.member[bitcast<u32>(select(0i, _e875, (_e875 > 0i)))];
let _e882 = (_e844 + 4i);
let _e884 = select(_e846, _e882, (_e882 < _e846));
let _e890 = global_6.member[bitcast<u32>(select(0i, _e884, (_e884 > 0i)))];
let _e891 = (_e844 + 5i);
let _e893 = select(_e846, _e891, (_e891 < _e846));
let _e899 = global_6.member[bitcast<u32>(select(0i, _e893, (_e893 > 0i)))];
let _e900 = (_e844 + 6i);
let _e902 = select(_e846, _e900, (_e900 < _e846));
let _e908 = global_6.member[bitcast<u32>(select(0i, _e902, (_e902 > 0i)))];
let _e909 = (_e844 + 7i);
let _e911 = select(_e846, _e909, (_e909 < _e846));
let _e917 = global_6.member[bitcast<u32>(select(0i, _e911, (_e911 > 0i)))];
let _e918 = (_e844 + 8i);
let _e920 = select(_e846, _e918, (_e918 < _e846));
let _e926 = global_6.member[bitcast<u32>(select(0i, _e920, (_e920 > 0i)))];
let _e927 = (_e881 - _e854);
let _e928 = (_e890 - _e863);
let _e929 = (_e899 - _e872);
let _e930 = (_e908 - _e854);
let _e931 = (_e917 - _e863);
let _e932 = (_e926 - _e872);
let _e935 = ((_e928 * _e932) - (_e929 * _e931));
let _e938 = ((_e929 * _e930) - (_e927 * _e932));
let _e941 = ((_e927 * _e931) - (_e928 * _e930));
let _e942 = (_e881 - _e790);
let _e943 = (_e890 - _e791);
let _e944 = (_e899 - _e792);
let _e945 = (_e908 - _e790);
let _e946 = (_e917 - _e791);
let _e947 = (_e926 - _e792);
let _e961 = (((((_e943 * _e947) - (_e944 * _e946)) * _e935) + (((_e944 * _e945) - (_e942 * _e947)) * _e938)) + (((_e942 * _e946) - (_e943 * _e945)) * _e941));
let _e963 = select(0f, _e961, (_e961 > 0f));
let _e964 = (_e854 - _e790);
let _e965 = (_e863 - _e791);
let _e966 = (_e872 - _e792);
let _e980 = (((((_e946 * _e966) - (_e947 * _e965)) * _e935) + (((_e947 * _e964) - (_e945 * _e966)) * _e938)) + (((_e945 * _e965) - (_e946 * _e964)) * _e941));
let _e982 = select(0f, _e980, (_e980 > 0f));
let _e996 = (((((_e965 * _e944) - (_e966 * _e943)) * _e935) + (((_e966 * _e942) - (_e964 * _e944)) * _e938)) + (((_e964 * _e943) - (_e965 * _e942)) * _e941));
let _e998 = select(0f, _e996, (_e996 > 0f));
let _e1000 = ((_e963 + _e982) + _e998);
let _e1002 = select(1e-30f, _e1000, (_e1000 > 1e-30f));
let _e1003 = (_e963 / _e1002);
let _e1004 = (_e982 / _e1002);
let _e1005 = (_e998 / _e1002);
let _e1010 = (((_e935 * _e935) + (_e938 * _e938)) + (_e941 * _e941));
let _e1013 = sqrt(select(0f, _e1010, (_e1010 > 0f)));
let _e1016 = (1f / select(1e-20f, _e1013, (_e1013 > 1e-20f)));
let _e1021 = (_e844 + 9i);
let _e1023 = select(_e846, _e1021, (_e1021 < _e846));
let _e1029 = global_6.member[bitcast<u32>(select(0i, _e1023, (_e1023 > 0i)))];
let _e1030 = (_e844 + 10i);
let _e1032 = select(_e846, _e1030, (_e1030 < _e846));
let _e1038 = global_6.member[bitcast<u32>(select(0i, _e1032, (_e1032 > 0i)))];
let _e1039 = (_e844 + 11i);
let _e1041 = select(_e846, _e1039, (_e1039 < _e846));
let _e1047 = global_6.member[bitcast<u32>(select(0i, _e1041, (_e1041 > 0i)))];
let _e1051 = (_e844 + 12i);
let _e1053 = select(_e846, _e1051, (_e1051 < _e846));
let _e1059 = global_6.member[bitcast<u32>(select(0i, _e1053, (_e1053 > 0i)))];
let _e1060 = (_e844 + 13i);
let _e1062 = select(_e846, _e1060, (_e1060 < _e846));
let _e1068 = global_6.member[bitcast<u32>(select(0i, _e1062, (_e1062 > 0i)))];
let _e1069 = (_e844 + 14i);
let _e1071 = select(_e846, _e1069, (_e1069 < _e846));
let _e1077 = global_6.member[bitcast<u32>(select(0i, _e1071, (_e1071 > 0i)))];
let _e1084 = (_e844 + 15i);
let _e1086 = select(_e846, _e1084, (_e1084 < _e846));
let _e1092 = global_6.member[bitcast<u32>(select(0i, _e1086, (_e1086 > 0i)))];
let _e1093 = (_e844 + 16i);
let _e1095 = select(_e846, _e1093, (_e1093 < _e846));
let _e1101 = global_6.member[bitcast<u32>(select(0i, _e1095, (_e1095 > 0i)))];
let _e1102 = (_e844 + 17i);
let _e1104 = select(_e846, _e1102, (_e1102 < _e846));
let _e1110 = global_6.member[bitcast<u32>(select(0i, _e1104, (_e1104 > 0i)))];
let _e1114 = (((_e1029 * _e1003) + (_e1059 * _e1004)) + (_e1092 * _e1005));
let _e1115 = (((_e1038 * _e1003) + (_e1068 * _e1004)) + (_e1101 * _e1005));
let _e1116 = (((_e1047 * _e1003) + (_e1077 * _e1004)) + (_e1110 * _e1005));
let _e1121 = (((_e1114 * _e1114) + (_e1115 * _e1115)) + (_e1116 * _e1116));
let _e1124 = sqrt(select(0f, _e1121, (_e1121 > 0f)));
let _e1127 = (1f / select(1e-20f, _e1124, (_e1124 > 1e-20f)));
let _e1132 = (_e844 + 18i);
let _e1134 = select(_e846, _e1132, (_e1132 < _e846));
let _e1140 = global_6.member[bitcast<u32>(select(0i, _e1134, (_e1134 > 0i)))];
let _e1149 = (select(select(0i, select(select(i32(_e1140), i32(-2147483648), (_e1140 < -2147483600f)), 2147483647i, (_e1140 > 2147483500f)), (_e1140 == _e1140)), _e688, ((_e796 & 1u) != 0u)) * 10i);
let _e1151 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e1153 = select(_e1151, _e1149, (_e1149 < _e1151));
let _e1159 = global_7.member[bitcast<u32>(select(0i, _e1153, (_e1153 > 0i)))];
let _e1160 = (_e1149 + 1i);
let _e1162 = select(_e1151, _e1160, (_e1160 < _e1151));
let _e1168 = global_7.member[bitcast<u32>(select(0i, _e1162, (_e1162 > 0i)))];
let _e1169 = (_e1149 + 2i);
let _e1171 = select(_e1151, _e1169, (_e1169 < _e1151));
let _e1177 = global_7.member[bitcast<u32>(select(0i, _e1171, (_e1171 > 0i)))];
let _e1181 = (_e1149 + 3i);
let _e1183 = select(_e1151, _e1181, (_e1181 < _e1151));
let _e1189 = global_7.member[bitcast<u32>(select(0i, _e1183, (_e1183 > 0i)))];
let _e1190 = (_e1149 + 4i);
let _e1192 = select(_e1151, _e1190, (_e1190 < _e1151));
let _e1198 = global_7.member[bitcast<u32>(select(0i, _e1192, (_e1192 > 0i)))];
let _e1199 = (_e1149 + 5i);
let _e1201 = select(_e1151, _e1199, (_e1199 < _e1151));
let _e1207 = global_7.member[bitcast<u32>(select(0i, _e1201, (_e1201 > 0i)))];
let _e1214 = (_e1149 + 6i);
let _e1216 = select(_e1151, _e1214, (_e1214 < _e1151));
let _e1222 = global_7.member[bitcast<u32>(select(0i, _e1216, (_e1216 > 0i)))];
let _e1223 = (_e1149 + 7i);
let _e1225 = select(_e1151, _e1223, (_e1223 < _e1151));
let _e1231 = global_7.member[bitcast<u32>(select(0i, _e1225, (_e1225 > 0i)))];
let _e1232 = (_e1149 + 8i);
let _e1234 = select(_e1151, _e1232, (_e1232 < _e1151));
let _e1240 = global_7.member[bitcast<u32>(select(0i, _e1234, (_e1234 > 0i)))];
let _e1248 = (_e1149 + 9i);
let _e1250 = select(_e1151, _e1248, (_e1248 < _e1151));
let _e1256 = global_7.member[bitcast<u32>(select(0i, _e1250, (_e1250 > 0i)))];
phi_2414_ = type_26(_e793, vec3<f32>((_e935 * _e1016), (_e938 * _e1016), (_e941 * _e1016)), vec3<f32>((_e1114 * _e1127), (_e1115 * _e1127), (_e1116 * _e1127)), vec3<f32>((((_e1159 * _e1003) + (_e1189 * _e1004)) + (_e1222 * _e1005)), (((_e1168 * _e1003) + (_e1198 * _e1004)) + (_e1231 * _e1005)), (((_e1177 * _e1003) + (_e1207 * _e1004)) + (_e1240 * _e1005))), _e1256, true);
} else {
let _e800 = (_e688 == -3i);
let _e806 = global_1.member.member_14.member_1.member.member;
let _e811 = global_1.member.member_14.member_1.member_1;
let _e817 = global_1.member.member_14.member.member.member;
let _e822 = global_1.member.member_14.member.member_1;
let _e832 = vec3<f32>(select(_e817.member, _e806.member, _e800), select(_e817.member_1, _e806.member_1, _e800), select(_e817.member_2, _e806.member_2, _e800));
phi_2414_ = type_26(_e793, _e832, _e832, vec3<f32>(select(_e822.member, _e811.member, _e800), select(_e822.member_1, _e811.member_1, _e800), select(_e822.member_2, _e811.member_2, _e800)), 0f, false);
}
let _e1259 = phi_2414_;
let _e1262 = ((select(0i, _e688, _e799) * 19i) + 18i);
let _e1264 = (bitcast<i32>(_e138) - 1i);
let _e1266 = select(_e1264, _e1262, (_e1262 < _e1264));
let _e1272 = global_6.member[bitcast<u32>(select(0i, _e1266, (_e1266 > 0i)))];
let _e1279 = select(0i, select(select(i32(_e1272), i32(-2147483648), (_e1272 < -2147483600f)), 2147483647i, (_e1272 > 2147483500f)), (_e1272 == _e1272));
let _e1280 = (_e1279 * 4i);
let _e1282 = (bitcast<i32>(arrayLength((&global_8.member))) - 1i);
let _e1284 = select(_e1282, _e1280, (_e1280 < _e1282));
let _e1290 = global_8.member[bitcast<u32>(select(0i, _e1284, (_e1284 > 0i)))];
if _e799 {
phi_2478_ = (select(_e1290, 1f, (_e1279 == 16i)) == 0f);
} else {
phi_2478_ = (_e688 != -1i);
}
let _e1296 = phi_2478_;
if _e1296 {
let _e1300 = (_e494 + (_e560 * _e670));
let _e1301 = (_e505 + (_e571 * _e670));
let _e1302 = (_e516 + (_e582 * _e670));
let _e1306 = (_e527 + (_e593 * _e670));
let _e1307 = (_e538 + (_e604 * _e670));
let _e1308 = (_e549 + (_e615 * _e670));
let _e1317 = (((_e461 * _e1259.member_1.x) + (_e472 * _e1259.member_1.y)) + (_e483 * _e1259.member_1.z));
if ((_e1317 * _e1317) > 1e-12f) {
phi_2510_ = (1f / _e1317);
} else {
phi_2510_ = 0f;
}
let _e1322 = phi_2510_;
let _e1328 = ((((_e1300 * _e1259.member_1.x) + (_e1301 * _e1259.member_1.y)) + (_e1302 * _e1259.member_1.z)) * _e1322);
let _e1332 = (_e1300 - (_e461 * _e1328));
let _e1333 = (_e1301 - (_e472 * _e1328));
let _e1334 = (_e1302 - (_e483 * _e1328));
let _e1340 = ((((_e1306 * _e1259.member_1.x) + (_e1307 * _e1259.member_1.y)) + (_e1308 * _e1259.member_1.z)) * _e1322);
let _e1344 = (_e1306 - (_e461 * _e1340));
let _e1345 = (_e1307 - (_e472 * _e1340));
let _e1346 = (_e1308 - (_e483 * _e1340));
let _e1350 = global_1.member.member_11.member;
phi_2551_ = vec3<f32>(0f, 0f, 0f);
phi_2554_ = 1u;
loop {
let _e1354 = phi_2551_;
let _e1356 = phi_2554_;
local_30 = _e1354;
local_31 = _e1354;
local_32 = _e1354;
let _e1360 = global_1.member.member_12.member_8;
let _e1361 = (_e1356 <= _e1360);
if _e1361 {
let _e1365 = global_1.member.member_12.member_5;
phi_2574_ = 0u;
loop {
let _e1369 = phi_2574_;
local_29 = _e1369;
let _e1373 = ((1u << bitcast<u32>((_e1369 & 31u))) < _e1350);
if _e1373 {
phi_2575_ = (_e1369 + 1u);
} else {
phi_2575_ = u32();
}
let _e1376 = phi_2575_;
continue;
continuing {
phi_2574_ = _e1376;
break if !(_e1373);
}
}
phi_2587_ = 0u;
loop {
let _e1379 = phi_2587_;
local_17 = _e1379;
local_18 = _e1379;
let _e1383 = ((1u << bitcast<u32>((_e1379 & 31u))) < _e1350);
if _e1383 {
phi_2588_ = (_e1379 + 1u);
} else {
phi_2588_ = u32();
}
let _e1386 = phi_2588_;
continue;
continuing {
phi_2587_ = _e1386;
break if !(_e1383);
}
}
let _e1389 = local_17;
let _e1392 = local_18;
phi_2605_ = 0u;
loop {
let _e1395 = phi_2605_;
local_21 = _e1395;
let _e1399 = ((1u << bitcast<u32>((_e1395 & 31u))) < _e1350);
if _e1399 {
phi_2606_ = (_e1395 + 1u);
} else {
phi_2606_ = u32();
}
let _e1402 = phi_2606_;
continue;
continuing {
phi_2605_ = _e1402;
break if !(_e1399);
}
}
phi_2618_ = 0u;
loop {
let _e1405 = phi_2618_;
local_19 = _e1405;
local_20 = _e1405;
let _e1409 = ((1u << bitcast<u32>((_e1405 & 31u))) < _e1350);
if _e1409 {
phi_2619_ = (_e1405 + 1u);
} else {
phi_2619_ = u32();
}
let _e1412 = phi_2619_;
continue;
continuing {
phi_2618_ = _e1412;
break if !(_e1409);
}
}
let _e1415 = local_19;
let _e1418 = local_20;
let _e1421 = local_21;
let _e1430 = global_1.member.member_12.member_7;
phi_2644_ = 0u;
loop {
let _e1433 = phi_2644_;
local_22 = _e1433;
local_23 = _e1433;
let _e1437 = ((1u << bitcast<u32>((_e1433 & 31u))) < _e1350);
if _e1437 {
phi_2645_ = (_e1433 + 1u);
} else {
phi_2645_ = u32();
}
let _e1440 = phi_2645_;
continue;
continuing {
phi_2644_ = _e1440;
break if !(_e1437);
}
}
let _e1443 = local_22;
let _e1446 = local_23;
phi_2662_ = 0u;
loop {
let _e1449 = phi_2662_;
local_24 = _e1449;
local_25 = _e1449;
let _e1453 = ((1u << bitcast<u32>((_e1449 & 31u))) < _e1350);
if _e1453 {
phi_2663_ = (_e1449 + 1u);
} else {
phi_2663_ = u32();
}
let _e1456 = phi_2663_;
continue;
continuing {
phi_2662_ = _e1456;
break if !(_e1453);
}
}
let _e1459 = local_24;
let _e1465 = local_25;
phi_2685_ = 0u;
loop {
let _e1475 = phi_2685_;
local_28 = _e1475;
let _e1479 = ((1u << bitcast<u32>((_e1475 & 31u))) < _e1350);
if _e1479 {
phi_2686_ = (_e1475 + 1u);
} else {
phi_2686_ = u32();
}
let _e1482 = phi_2686_;
continue;
continuing {
phi_2685_ = _e1482;
break if !(_e1479);
}
}
phi_2698_ = 0u;
loop {
let _e1485 = phi_2698_;
local_26 = _e1485;
local_27 = _e1485;
let _e1489 = ((1u << bitcast<u32>((_e1485 & 31u))) < _e1350);
if _e1489 {
phi_2699_ = (_e1485 + 1u);
} else {
phi_2699_ = u32();
}
let _e1492 = phi_2699_;
continue;
continuing {
phi_2698_ = _e1492;
break if !(_e1489);
}
}
let _e1495 = local_26;
let _e1498 = local_27;
let _e1501 = local_28;
let _e1507 = (((((1u << bitcast<u32>(((2u * _e1459) & 31u))) - (1u << bitcast<u32>(((2u * (_e1465 - select(6u, _e1446, (_e1443 < 6u)))) & 31u)))) / 3u) * 4u) + (1u << bitcast<u32>(((2u * (_e1501 - select(6u, _e1498, (_e1495 < 6u)))) & 31u))));
let _e1508 = (_e1507 / 64u);
if ((_e1507 % 64u) > 0u) {
phi_2735_ = (_e1508 + 1u);
} else {
phi_2735_ = _e1508;
}
let _e1513 = phi_2735_;
let _e1516 = local_29;
local_14 = type_24(_e1516, select(6u, _e1392, (_e1389 < 6u)), (1u << bitcast<u32>(((2u * (_e1421 - select(6u, _e1418, (_e1415 < 6u)))) & 31u))), (_e1356 * _e1430), (_e1513 * 64u));
let _e1519 = local_14.member_1;
phi_2748_ = _e1354;
phi_2751_ = type_17(_e1519, 0u);
loop {
let _e1522 = phi_2748_;
let _e1524 = phi_2751_;
local_35 = _e1522;
let _e1527 = local_14.member_1;
let _e1530 = local_14.member_2;
let _e1532 = ((_e1524.member < _e1527) || (_e1524.member_1 < _e1530));
if _e1532 {
local_12.member = _e1524.member;
local_12.member_1 = _e1524.member_1;
let _e1536 = local_12.member;
let _e1537 = local_12.member_1;
let _e1539 = local_14.member;
let _e1554 = local_14.member_3;
let _e1556 = local_14.member_4;
local_13 = ((_e1554 + (18u * _e1556)) + (((((1u << bitcast<u32>(((2u * _e1539) & 31u))) - (1u << bitcast<u32>(((2u * (_e1539 - _e1536)) & 31u)))) / 3u) * 4u) + _e1537));
let _e1560 = local_13;
let _e1561 = bitcast<i32>(_e1560);
let _e1563 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e1565 = select(_e1563, _e1561, (_e1561 < _e1563));
let _e1570 = global_4.member[bitcast<u32>(select(0i, _e1565, (_e1565 > 0i)))];
let _e1571 = local_13;
let _e1572 = local_14.member_4;
let _e1574 = bitcast<i32>((_e1571 + _e1572));
let _e1576 = select(_e1563, _e1574, (_e1574 < _e1563));
let _e1581 = global_4.member[bitcast<u32>(select(0i, _e1576, (_e1576 > 0i)))];
let _e1582 = local_13;
let _e1583 = local_14.member_4;
let _e1586 = bitcast<i32>((_e1582 + (2u * _e1583)));
let _e1588 = select(_e1563, _e1586, (_e1586 < _e1563));
let _e1593 = global_4.member[bitcast<u32>(select(0i, _e1588, (_e1588 > 0i)))];
let _e1594 = local_12.member;
let _e1595 = local_12.member_1;
let _e1596 = local_14.member;
let _e1610 = local_14.member_3;
let _e1611 = local_14.member_4;
local_11 = ((_e1610 + (21u * _e1611)) + (((((1u << bitcast<u32>(((2u * _e1596) & 31u))) - (1u << bitcast<u32>(((2u * (_e1596 - _e1594)) & 31u)))) / 3u) * 4u) + _e1595));
let _e1615 = local_11;
let _e1616 = bitcast<i32>(_e1615);
let _e1618 = select(_e1563, _e1616, (_e1616 < _e1563));
let _e1623 = global_4.member[bitcast<u32>(select(0i, _e1618, (_e1618 > 0i)))];
let _e1624 = local_11;
let _e1625 = local_14.member_4;
let _e1627 = bitcast<i32>((_e1624 + _e1625));
let _e1629 = select(_e1563, _e1627, (_e1627 < _e1563));
let _e1634 = global_4.member[bitcast<u32>(select(0i, _e1629, (_e1629 > 0i)))];
let _e1635 = local_11;
let _e1636 = local_14.member_4;
let _e1639 = bitcast<i32>((_e1635 + (2u * _e1636)));
let _e1641 = select(_e1563, _e1639, (_e1639 < _e1563));
let _e1646 = global_4.member[bitcast<u32>(select(0i, _e1641, (_e1641 > 0i)))];
let _e1668 = ((((_e1570 <= _e1623) && ((_e1259.member.x >= (_e1570 - 0.05f)) && (_e1259.member.x <= (_e1623 + 0.05f)))) && ((_e1259.member.y >= (_e1581 - 0.05f)) && (_e1259.member.y <= (_e1634 + 0.05f)))) && ((_e1259.member.z >= (_e1593 - 0.05f)) && (_e1259.member.z <= (_e1646 + 0.05f))));
if (_e1668 && (_e1524.member > 0u)) {
phi_5309_ = _e1522;
phi_5310_ = type_17((_e1524.member - 1u), (_e1524.member_1 << bitcast<u32>(2i)));
} else {
if _e1668 {
let _e1671 = (_e1524.member_1 & 1431655765u);
let _e1675 = ((_e1671 | (_e1671 >> bitcast<u32>(1i))) & 858993459u);
let _e1679 = ((_e1675 | (_e1675 >> bitcast<u32>(2i))) & 252645135u);
let _e1683 = ((_e1679 | (_e1679 >> bitcast<u32>(4i))) & 16711935u);
let _e1690 = ((_e1524.member_1 >> bitcast<u32>(1i)) & 1431655765u);
let _e1694 = ((_e1690 | (_e1690 >> bitcast<u32>(1i))) & 858993459u);
let _e1698 = ((_e1694 | (_e1694 >> bitcast<u32>(2i))) & 252645135u);
let _e1702 = ((_e1698 | (_e1698 >> bitcast<u32>(4i))) & 16711935u);
local_8 = bitcast<i32>((_e1356 * _e1365));
local_9 = bitcast<i32>(((((_e1702 | (_e1702 >> bitcast<u32>(8i))) & 65535u) * _e1350) + ((_e1683 | (_e1683 >> bitcast<u32>(8i))) & 65535u)));
local_10 = bitcast<i32>((_e1350 * _e1350));
let _e1710 = local_8;
let _e1711 = local_9;
let _e1712 = (_e1710 + _e1711);
let _e1714 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e1716 = select(_e1714, _e1712, (_e1712 < _e1714));
let _e1721 = global_3.member[bitcast<u32>(select(0i, _e1716, (_e1716 > 0i)))];
let _e1722 = local_8;
let _e1723 = local_10;
let _e1725 = local_9;
let _e1726 = ((_e1722 + _e1723) + _e1725);
let _e1728 = select(_e1714, _e1726, (_e1726 < _e1714));
let _e1733 = global_3.member[bitcast<u32>(select(0i, _e1728, (_e1728 > 0i)))];
let _e1734 = local_8;
let _e1735 = local_10;
let _e1738 = local_9;
let _e1739 = ((_e1734 + (2i * _e1735)) + _e1738);
let _e1741 = select(_e1714, _e1739, (_e1739 < _e1714));
let _e1746 = global_3.member[bitcast<u32>(select(0i, _e1741, (_e1741 > 0i)))];
let _e1747 = local_8;
let _e1748 = local_10;
let _e1751 = local_9;
let _e1752 = ((_e1747 + (3i * _e1748)) + _e1751);
let _e1754 = select(_e1714, _e1752, (_e1752 < _e1714));
let _e1759 = global_3.member[bitcast<u32>(select(0i, _e1754, (_e1754 > 0i)))];
let _e1760 = local_8;
let _e1761 = local_10;
let _e1764 = local_9;
let _e1765 = ((_e1760 + (4i * _e1761)) + _e1764);
let _e1767 = select(_e1714, _e1765, (_e1765 < _e1714));
let _e1772 = global_3.member[bitcast<u32>(select(0i, _e1767, (_e1767 > 0i)))];
let _e1773 = local_8;
let _e1774 = local_10;
let _e1777 = local_9;
let _e1778 = ((_e1773 + (5i * _e1774)) + _e1777);
let _e1780 = select(_e1714, _e1778, (_e1778 < _e1714));
let _e1785 = global_3.member[bitcast<u32>(select(0i, _e1780, (_e1780 > 0i)))];
let _e1786 = local_8;
let _e1787 = local_10;
let _e1790 = local_9;
let _e1791 = ((_e1786 + (6i * _e1787)) + _e1790);
let _e1793 = select(_e1714, _e1791, (_e1791 < _e1714));
let _e1798 = global_3.member[bitcast<u32>(select(0i, _e1793, (_e1793 > 0i)))];
let _e1799 = local_8;
let _e1800 = local_10;
let _e1803 = local_9;
let _e1804 = ((_e1799 + (7i * _e1800)) + _e1803);
let _e1806 = select(_e1714, _e1804, (_e1804 < _e1714));
let _e1811 = global_3.member[bitcast<u32>(select(0i, _e1806, (_e1806 > 0i)))];
let _e1812 = local_8;
let _e1813 = local_10;
let _e1816 = local_9;
let _e1817 = ((_e1812 + (8i * _e1813)) + _e1816);
let _e1819 = select(_e1714, _e1817, (_e1817 < _e1714));
let _e1824 = global_3.member[bitcast<u32>(select(0i, _e1819, (_e1819 > 0i)))];
let _e1825 = local_8;
let _e1826 = local_10;
let _e1829 = local_9;
let _e1830 = ((_e1825 + (9i * _e1826)) + _e1829);
let _e1832 = select(_e1714, _e1830, (_e1830 < _e1714));
let _e1837 = global_3.member[bitcast<u32>(select(0i, _e1832, (_e1832 > 0i)))];
let _e1838 = local_8;
let _e1839 = local_10;
let _e1842 = local_9;
let _e1843 = ((_e1838 + (10i * _e1839)) + _e1842);
let _e1845 = select(_e1714, _e1843, (_e1843 < _e1714));
let _e1850 = global_3.member[bitcast<u32>(select(0i, _e1845, (_e1845 > 0i)))];
let _e1851 = local_8;
let _e1852 = local_10;
let _e1855 = local_9;
let _e1856 = ((_e1851 + (11i * _e1852)) + _e1855);
let _e1858 = select(_e1714, _e1856, (_e1856 < _e1714));
let _e1863 = global_3.member[bitcast<u32>(select(0i, _e1858, (_e1858 > 0i)))];
let _e1864 = local_8;
let _e1865 = local_10;
let _e1868 = local_9;
let _e1869 = ((_e1864 + (12i * _e1865)) + _e1868);
let _e1871 = select(_e1714, _e1869, (_e1869 < _e1714));
let _e1876 = global_3.member[bitcast<u32>(select(0i, _e1871, (_e1871 > 0i)))];
let _e1877 = local_8;
let _e1878 = local_10;
let _e1881 = local_9;
let _e1882 = ((_e1877 + (13i * _e1878)) + _e1881);
let _e1884 = select(_e1714, _e1882, (_e1882 < _e1714));
let _e1889 = global_3.member[bitcast<u32>(select(0i, _e1884, (_e1884 > 0i)))];
let _e1890 = local_8;
let _e1891 = local_10;
let _e1894 = local_9;
let _e1895 = ((_e1890 + (14i * _e1891)) + _e1894);
let _e1897 = select(_e1714, _e1895, (_e1895 < _e1714));
let _e1902 = global_3.member[bitcast<u32>(select(0i, _e1897, (_e1897 > 0i)))];
let _e1903 = local_8;
let _e1904 = local_10;
let _e1907 = local_9;
let _e1908 = ((_e1903 + (15i * _e1904)) + _e1907);
let _e1910 = select(_e1714, _e1908, (_e1908 < _e1714));
let _e1915 = global_3.member[bitcast<u32>(select(0i, _e1910, (_e1910 > 0i)))];
let _e1916 = local_8;
let _e1917 = local_10;
let _e1920 = local_9;
let _e1921 = ((_e1916 + (16i * _e1917)) + _e1920);
let _e1923 = select(_e1714, _e1921, (_e1921 < _e1714));
let _e1928 = global_3.member[bitcast<u32>(select(0i, _e1923, (_e1923 > 0i)))];
let _e1929 = local_8;
let _e1930 = local_10;
let _e1933 = local_9;
let _e1934 = ((_e1929 + (17i * _e1930)) + _e1933);
let _e1936 = select(_e1714, _e1934, (_e1934 < _e1714));
let _e1941 = global_3.member[bitcast<u32>(select(0i, _e1936, (_e1936 > 0i)))];
let _e1942 = local_8;
let _e1943 = local_10;
let _e1946 = local_9;
let _e1947 = ((_e1942 + (18i * _e1943)) + _e1946);
let _e1949 = select(_e1714, _e1947, (_e1947 < _e1714));
let _e1954 = global_3.member[bitcast<u32>(select(0i, _e1949, (_e1949 > 0i)))];
let _e1955 = local_8;
let _e1956 = local_10;
let _e1959 = local_9;
let _e1960 = ((_e1955 + (19i * _e1956)) + _e1959);
let _e1962 = select(_e1714, _e1960, (_e1960 < _e1714));
let _e1967 = global_3.member[bitcast<u32>(select(0i, _e1962, (_e1962 > 0i)))];
let _e1968 = local_8;
let _e1969 = local_10;
let _e1972 = local_9;
let _e1973 = ((_e1968 + (20i * _e1969)) + _e1972);
let _e1975 = select(_e1714, _e1973, (_e1973 < _e1714));
let _e1980 = global_3.member[bitcast<u32>(select(0i, _e1975, (_e1975 > 0i)))];
let _e1981 = local_8;
let _e1982 = local_10;
let _e1985 = local_9;
let _e1986 = ((_e1981 + (23i * _e1982)) + _e1985);
let _e1988 = select(_e1714, _e1986, (_e1986 < _e1714));
let _e1993 = global_3.member[bitcast<u32>(select(0i, _e1988, (_e1988 > 0i)))];
let _e1994 = local_8;
let _e1995 = local_10;
let _e1998 = local_9;
let _e1999 = ((_e1994 + (24i * _e1995)) + _e1998);
let _e2001 = select(_e1714, _e1999, (_e1999 < _e1714));
let _e2006 = global_3.member[bitcast<u32>(select(0i, _e2001, (_e2001 > 0i)))];
let _e2011 = (((_e1259.member_1.x * _e1759) + (_e1259.member_1.y * _e1772)) + (_e1259.member_1.z * _e1785));
let _e2014 = bitcast<f32>((bitcast<u32>(_e2011) & 2147483647u));
if (_e2014 < 1e-6f) {
phi_5262_ = vec3<f32>();
phi_5263_ = true;
} else {
let _e2016 = (1f / _e2011);
let _e2025 = ((((_e1259.member_1.x * (_e1259.member.x - _e1721)) + (_e1259.member_1.y * (_e1259.member.y - _e1733))) + (_e1259.member_1.z * (_e1259.member.z - _e1746))) * _e2016);
let _e2029 = (_e1798 + (_e1876 * _e2025));
let _e2030 = (_e1811 + (_e1889 * _e2025));
let _e2031 = (_e1824 + (_e1902 * _e2025));
let _e2037 = ((((_e1259.member_1.x * _e2029) + (_e1259.member_1.y * _e2030)) + (_e1259.member_1.z * _e2031)) * _e2016);
let _e2041 = (_e2029 - (_e1759 * _e2037));
let _e2042 = (_e2030 - (_e1772 * _e2037));
let _e2043 = (_e2031 - (_e1785 * _e2037));
let _e2047 = (_e1837 + (_e1915 * _e2025));
let _e2048 = (_e1850 + (_e1928 * _e2025));
let _e2049 = (_e1863 + (_e1941 * _e2025));
let _e2055 = ((((_e1259.member_1.x * _e2047) + (_e1259.member_1.y * _e2048)) + (_e1259.member_1.z * _e2049)) * _e2016);
let _e2059 = (_e2047 - (_e1759 * _e2055));
let _e2060 = (_e2048 - (_e1772 * _e2055));
let _e2061 = (_e2049 - (_e1785 * _e2055));
if ((_e2025 < -(0.05f)) || (bitcast<f32>((bitcast<u32>((_e2025 - _e2006)) & 2147483647u)) > ((0.5f * (bitcast<f32>((bitcast<u32>((((_e2041 * _e1759) + (_e2042 * _e1772)) + (_e2043 * _e1785))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((((_e2059 * _e1759) + (_e2060 * _e1772)) + (_e2061 * _e1785))) & 2147483647u)))) + 0.05f))) {
phi_5257_ = vec3<f32>();
phi_5258_ = true;
} else {
let _e2102 = (((((_e2042 * _e2061) - (_e2043 * _e2060)) * _e1259.member_1.x) + (((_e2043 * _e2059) - (_e2041 * _e2061)) * _e1259.member_1.y)) + (((_e2041 * _e2060) - (_e2042 * _e2059)) * _e1259.member_1.z));
let _e2105 = bitcast<f32>((bitcast<u32>(_e2102) & 2147483647u));
if (_e2105 < 1e-12f) {
phi_5252_ = vec3<f32>();
phi_5253_ = true;
} else {
let _e2113 = (_e1259.member.x - (_e1721 + (_e1759 * _e2025)));
let _e2114 = (_e1259.member.y - (_e1733 + (_e1772 * _e2025)));
let _e2115 = (_e1259.member.z - (_e1746 + (_e1785 * _e2025)));
let _e2130 = ((((((_e2114 * _e2061) - (_e2115 * _e2060)) * _e1259.member_1.x) + (((_e2115 * _e2059) - (_e2113 * _e2061)) * _e1259.member_1.y)) + (((_e2113 * _e2060) - (_e2114 * _e2059)) * _e1259.member_1.z)) / _e2102);
let _e2145 = ((((((_e2042 * _e2115) - (_e2043 * _e2114)) * _e1259.member_1.x) + (((_e2043 * _e2113) - (_e2041 * _e2115)) * _e1259.member_1.y)) + (((_e2041 * _e2114) - (_e2042 * _e2113)) * _e1259.member_1.z)) / _e2102);
let _e2208 = bitcast<f32>((bitcast<u32>(((((((_e1333 * _e2061) - (_e1334 * _e2060)) * _e1259.member_1.x) + (((_e1334 * _e2059) - (_e1332 * _e2061)) * _e1259.member_1.y)) + (((_e1332 * _e2060) - (_e1333 * _e2059)) * _e1259.member_1.z)) / _e2102)) & 2147483647u));
let _e2211 = bitcast<f32>((bitcast<u32>(((((((_e1345 * _e2061) - (_e1346 * _e2060)) * _e1259.member_1.x) + (((_e1346 * _e2059) - (_e1344 * _e2061)) * _e1259.member_1.y)) + (((_e1344 * _e2060) - (_e1345 * _e2059)) * _e1259.member_1.z)) / _e2102)) & 2147483647u));
let _e2213 = select(_e2211, _e2208, (_e2208 > _e2211));
let _e2215 = select(1e-3f, _e2213, (_e2213 > 1e-3f));
let _e2218 = bitcast<f32>((bitcast<u32>(((((((_e2042 * _e1334) - (_e2043 * _e1333)) * _e1259.member_1.x) + (((_e2043 * _e1332) - (_e2041 * _e1334)) * _e1259.member_1.y)) + (((_e2041 * _e1333) - (_e2042 * _e1332)) * _e1259.member_1.z)) / _e2102)) & 2147483647u));
let _e2221 = bitcast<f32>((bitcast<u32>(((((((_e2042 * _e1346) - (_e2043 * _e1345)) * _e1259.member_1.x) + (((_e2043 * _e1344) - (_e2041 * _e1346)) * _e1259.member_1.y)) + (((_e2041 * _e1345) - (_e2042 * _e1344)) * _e1259.member_1.z)) / _e2102)) & 2147483647u));
let _e2223 = select(_e2221, _e2218, (_e2218 > _e2221));
let _e2225 = select(1e-3f, _e2223, (_e2223 > 1e-3f));
let _e2238 = ((bitcast<f32>((bitcast<u32>(_e2130) & 2147483647u)) > (0.5f * (1f + _e2215))) || (bitcast<f32>((bitcast<u32>(_e2145) & 2147483647u)) > (0.5f * (1f + _e2225))));
if _e2238 {
phi_5251_ = vec3<f32>();
} else {
let _e2239 = (1e-4f * _e2215);
let _e2241 = select(_e2239, 1f, (1f > _e2239));
let _e2243 = select(_e2239, 1e-4f, (1e-4f > _e2239));
let _e2245 = (0.5f * (_e2241 + _e2243));
let _e2246 = (0.5f / _e2243);
let _e2247 = (1f / _e2241);
let _e2249 = (0.5f * _e2215);
let _e2250 = (_e2130 + _e2249);
let _e2251 = -(_e2250);
let _e2254 = (_e2245 - select(_e2251, _e2250, (_e2250 > _e2251)));
let _e2256 = select(0f, _e2254, (_e2254 > 0f));
let _e2258 = select(_e2243, _e2256, (_e2256 < _e2243));
let _e2261 = (_e2254 - _e2243);
let _e2265 = (((_e2258 * (_e2258 * _e2246)) + select(0f, _e2261, (_e2261 > 0f))) * _e2247);
let _e2269 = (_e2130 - _e2249);
let _e2270 = -(_e2269);
let _e2273 = (_e2245 - select(_e2270, _e2269, (_e2269 > _e2270)));
let _e2275 = select(0f, _e2273, (_e2273 > 0f));
let _e2277 = select(_e2243, _e2275, (_e2275 < _e2243));
let _e2280 = (_e2273 - _e2243);
let _e2284 = (((_e2277 * (_e2277 * _e2246)) + select(0f, _e2280, (_e2280 > 0f))) * _e2247);
let _e2290 = (1e-4f * _e2225);
let _e2292 = select(_e2290, 1f, (1f > _e2290));
let _e2294 = select(_e2290, 1e-4f, (1e-4f > _e2290));
let _e2296 = (0.5f * (_e2292 + _e2294));
let _e2297 = (0.5f / _e2294);
let _e2298 = (1f / _e2292);
let _e2300 = (0.5f * _e2225);
let _e2301 = (_e2145 + _e2300);
let _e2302 = -(_e2301);
let _e2305 = (_e2296 - select(_e2302, _e2301, (_e2301 > _e2302)));
let _e2307 = select(0f, _e2305, (_e2305 > 0f));
let _e2309 = select(_e2294, _e2307, (_e2307 < _e2294));
let _e2312 = (_e2305 - _e2294);
let _e2316 = (((_e2309 * (_e2309 * _e2297)) + select(0f, _e2312, (_e2312 > 0f))) * _e2298);
let _e2320 = (_e2145 - _e2300);
let _e2321 = -(_e2320);
let _e2324 = (_e2296 - select(_e2321, _e2320, (_e2320 > _e2321)));
let _e2326 = select(0f, _e2324, (_e2324 > 0f));
let _e2328 = select(_e2294, _e2326, (_e2326 < _e2294));
let _e2331 = (_e2324 - _e2294);
let _e2335 = (((_e2328 * (_e2328 * _e2297)) + select(0f, _e2331, (_e2331 > 0f))) * _e2298);
let _e2345 = (select(_e1993, _e2025, (_e2025 < _e1993)) - 0f);
let _e2349 = global_1.member.member_13.member_6;
if (_e2349 == 0u) {
phi_4918_ = _e2345;
} else {
let _e2352 = (_e2345 / f32(_e2349));
phi_4205_ = 0u;
phi_4208_ = 0f;
loop {
let _e2354 = phi_4205_;
let _e2356 = phi_4208_;
local_33 = _e2356;
let _e2359 = ((_e2354 < _e2349) && (_e2345 > 0f));
if _e2359 {
let _e2362 = (0f + (_e2352 * f32(_e2354)));
let _e2363 = (_e2362 + _e2352);
let _e2365 = (0.5f * (_e2362 + _e2363));
let _e2366 = (_e2363 - _e2362);
let _e2367 = (0.28867513f * _e2366);
let _e2368 = (_e2365 - _e2367);
let _e2378 = global_1.member.member_13.member_7;
let _e2379 = bitcast<i32>(_e2378);
let _e2383 = global_1.member.member_13.member_8;
let _e2384 = bitcast<i32>(_e2383);
let _e2388 = global_1.member.member_13.member_9;
let _e2389 = bitcast<i32>(_e2388);
let _e2393 = global_1.member.member_13.member_4;
let _e2400 = global_1.member.member_13.member_5;
let _e2404 = f32(_e2379);
let _e2406 = (_e2400.member - _e2393.member);
let _e2409 = (((((_e1721 + (_e1759 * _e2368)) - _e2393.member) / _e2406) * _e2404) - 0.5f);
let _e2410 = (_e2404 - 1f);
let _e2412 = select(0f, _e2409, (_e2409 > 0f));
let _e2414 = select(_e2410, _e2412, (_e2412 < _e2410));
let _e2415 = f32(_e2384);
let _e2417 = (_e2400.member_1 - _e2393.member_1);
let _e2420 = (((((_e1733 + (_e1772 * _e2368)) - _e2393.member_1) / _e2417) * _e2415) - 0.5f);
let _e2421 = (_e2415 - 1f);
let _e2423 = select(0f, _e2420, (_e2420 > 0f));
let _e2425 = select(_e2421, _e2423, (_e2423 < _e2421));
let _e2426 = f32(_e2389);
let _e2428 = (_e2400.member_2 - _e2393.member_2);
let _e2431 = (((((_e1746 + (_e1785 * _e2368)) - _e2393.member_2) / _e2428) * _e2426) - 0.5f);
let _e2432 = (_e2426 - 1f);
let _e2434 = select(0f, _e2431, (_e2431 > 0f));
let _e2436 = select(_e2432, _e2434, (_e2434 < _e2432));
let _e2438 = select(0f, _e2414, (_e2414 > 0f));
let _e2440 = select(1e6f, _e2438, (_e2438 < 1e6f));
let _e2447 = select(0i, select(select(i32(_e2440), i32(-2147483648), (_e2440 < -2147483600f)), 2147483647i, (_e2440 > 2147483500f)), (_e2440 == _e2440));
let _e2451 = (_e2447 - select(0i, 1i, (_e2440 < f32(_e2447))));
let _e2453 = select(0f, _e2425, (_e2425 > 0f));
let _e2455 = select(1e6f, _e2453, (_e2453 < 1e6f));
let _e2462 = select(0i, select(select(i32(_e2455), i32(-2147483648), (_e2455 < -2147483600f)), 2147483647i, (_e2455 > 2147483500f)), (_e2455 == _e2455));
let _e2466 = (_e2462 - select(0i, 1i, (_e2455 < f32(_e2462))));
let _e2468 = select(0f, _e2436, (_e2436 > 0f));
let _e2470 = select(1e6f, _e2468, (_e2468 < 1e6f));
let _e2477 = select(0i, select(select(i32(_e2470), i32(-2147483648), (_e2470 < -2147483600f)), 2147483647i, (_e2470 > 2147483500f)), (_e2470 == _e2470));
let _e2481 = (_e2477 - select(0i, 1i, (_e2470 < f32(_e2477))));
let _e2485 = (_e2425 - f32(_e2466));
let _e2487 = (_e2436 - f32(_e2481));
local_6 = (_e2414 - f32(_e2451));
let _e2488 = (_e2451 + 1i);
let _e2490 = select(_e2488, 0i, (_e2488 < 0i));
if (_e2490 >= _e2379) {
phi_4343_ = (_e2379 - 1i);
} else {
phi_4343_ = _e2490;
}
let _e2494 = phi_4343_;
local_7 = (_e2494 - _e2451);
let _e2496 = (_e2466 + 1i);
let _e2498 = select(_e2496, 0i, (_e2496 < 0i));
if (_e2498 >= _e2384) {
phi_4356_ = (_e2384 - 1i);
} else {
phi_4356_ = _e2498;
}
let _e2502 = phi_4356_;
let _e2504 = ((_e2502 - _e2466) * _e2379);
let _e2505 = (_e2481 + 1i);
let _e2507 = select(_e2505, 0i, (_e2505 < 0i));
if (_e2507 >= _e2389) {
phi_4370_ = (_e2389 - 1i);
} else {
phi_4370_ = _e2507;
}
let _e2511 = phi_4370_;
let _e2518 = global_1.member.member_13.member_10;
let _e2519 = bitcast<i32>(_e2518);
let _e2524 = ((_e2519 + (((_e2481 * _e2384) + _e2466) * _e2379)) + _e2451);
let _e2526 = select(_e1282, _e2524, (_e2524 < _e1282));
let _e2531 = global_8.member[bitcast<u32>(select(0i, _e2526, (_e2526 > 0i)))];
let _e2532 = local_6;
let _e2535 = local_7;
let _e2536 = (_e2524 + _e2535);
let _e2538 = select(_e1282, _e2536, (_e2536 < _e1282));
let _e2543 = global_8.member[bitcast<u32>(select(0i, _e2538, (_e2538 > 0i)))];
let _e2544 = local_6;
let _e2547 = (1f - _e2485);
let _e2549 = (_e2524 + _e2504);
let _e2551 = select(_e1282, _e2549, (_e2549 < _e1282));
let _e2556 = global_8.member[bitcast<u32>(select(0i, _e2551, (_e2551 > 0i)))];
let _e2557 = local_6;
let _e2560 = local_7;
let _e2561 = (_e2549 + _e2560);
let _e2563 = select(_e1282, _e2561, (_e2561 < _e1282));
let _e2568 = global_8.member[bitcast<u32>(select(0i, _e2563, (_e2563 > 0i)))];
let _e2569 = local_6;
let _e2574 = (_e2524 + (((_e2511 - _e2481) * _e2379) * _e2384));
let _e2576 = select(_e1282, _e2574, (_e2574 < _e1282));
let _e2581 = global_8.member[bitcast<u32>(select(0i, _e2576, (_e2576 > 0i)))];
let _e2582 = local_6;
let _e2585 = local_7;
let _e2586 = (_e2574 + _e2585);
let _e2588 = select(_e1282, _e2586, (_e2586 < _e1282));
let _e2593 = global_8.member[bitcast<u32>(select(0i, _e2588, (_e2588 > 0i)))];
let _e2594 = local_6;
let _e2598 = (_e2574 + _e2504);
let _e2600 = select(_e1282, _e2598, (_e2598 < _e1282));
let _e2605 = global_8.member[bitcast<u32>(select(0i, _e2600, (_e2600 > 0i)))];
let _e2606 = local_6;
let _e2609 = local_7;
let _e2610 = (_e2598 + _e2609);
let _e2612 = select(_e1282, _e2610, (_e2610 < _e1282));
let _e2617 = global_8.member[bitcast<u32>(select(0i, _e2612, (_e2612 > 0i)))];
let _e2618 = local_6;
let _e2627 = (_e2365 + _e2367);
let _e2637 = (((((_e1721 + (_e1759 * _e2627)) - _e2393.member) / _e2406) * _e2404) - 0.5f);
let _e2639 = select(0f, _e2637, (_e2637 > 0f));
let _e2641 = select(_e2410, _e2639, (_e2639 < _e2410));
let _e2645 = (((((_e1733 + (_e1772 * _e2627)) - _e2393.member_1) / _e2417) * _e2415) - 0.5f);
let _e2647 = select(0f, _e2645, (_e2645 > 0f));
let _e2649 = select(_e2421, _e2647, (_e2647 < _e2421));
let _e2653 = (((((_e1746 + (_e1785 * _e2627)) - _e2393.member_2) / _e2428) * _e2426) - 0.5f);
let _e2655 = select(0f, _e2653, (_e2653 > 0f));
let _e2657 = select(_e2432, _e2655, (_e2655 < _e2432));
let _e2659 = select(0f, _e2641, (_e2641 > 0f));
let _e2661 = select(1e6f, _e2659, (_e2659 < 1e6f));
let _e2668 = select(0i, select(select(i32(_e2661), i32(-2147483648), (_e2661 < -2147483600f)), 2147483647i, (_e2661 > 2147483500f)), (_e2661 == _e2661));
let _e2672 = (_e2668 - select(0i, 1i, (_e2661 < f32(_e2668))));
let _e2674 = select(0f, _e2649, (_e2649 > 0f));
let _e2676 = select(1e6f, _e2674, (_e2674 < 1e6f));
let _e2683 = select(0i, select(select(i32(_e2676), i32(-2147483648), (_e2676 < -2147483600f)), 2147483647i, (_e2676 > 2147483500f)), (_e2676 == _e2676));
let _e2687 = (_e2683 - select(0i, 1i, (_e2676 < f32(_e2683))));
let _e2689 = select(0f, _e2657, (_e2657 > 0f));
let _e2691 = select(1e6f, _e2689, (_e2689 < 1e6f));
let _e2698 = select(0i, select(select(i32(_e2691), i32(-2147483648), (_e2691 < -2147483600f)), 2147483647i, (_e2691 > 2147483500f)), (_e2691 == _e2691));
let _e2702 = (_e2698 - select(0i, 1i, (_e2691 < f32(_e2698))));
let _e2706 = (_e2649 - f32(_e2687));
let _e2708 = (_e2657 - f32(_e2702));
local_4 = (_e2641 - f32(_e2672));
let _e2709 = (_e2672 + 1i);
let _e2711 = select(_e2709, 0i, (_e2709 < 0i));
if (_e2711 >= _e2379) {
phi_4686_ = (_e2379 - 1i);
} else {
phi_4686_ = _e2711;
}
let _e2715 = phi_4686_;
local_5 = (_e2715 - _e2672);
let _e2717 = (_e2687 + 1i);
let _e2719 = select(_e2717, 0i, (_e2717 < 0i));
if (_e2719 >= _e2384) {
phi_4699_ = (_e2384 - 1i);
} else {
phi_4699_ = _e2719;
}
let _e2723 = phi_4699_;
let _e2725 = ((_e2723 - _e2687) * _e2379);
let _e2726 = (_e2702 + 1i);
let _e2728 = select(_e2726, 0i, (_e2726 < 0i));
if (_e2728 >= _e2389) {
phi_4713_ = (_e2389 - 1i);
} else {
phi_4713_ = _e2728;
}
let _e2732 = phi_4713_;
let _e2740 = ((_e2519 + (((_e2702 * _e2384) + _e2687) * _e2379)) + _e2672);
let _e2742 = select(_e1282, _e2740, (_e2740 < _e1282));
let _e2747 = global_8.member[bitcast<u32>(select(0i, _e2742, (_e2742 > 0i)))];
let _e2748 = local_4;
let _e2751 = local_5;
let _e2752 = (_e2740 + _e2751);
let _e2754 = select(_e1282, _e2752, (_e2752 < _e1282));
let _e2759 = global_8.member[bitcast<u32>(select(0i, _e2754, (_e2754 > 0i)))];
let _e2760 = local_4;
let _e2763 = (1f - _e2706);
let _e2765 = (_e2740 + _e2725);
let _e2767 = select(_e1282, _e2765, (_e2765 < _e1282));
let _e2772 = global_8.member[bitcast<u32>(select(0i, _e2767, (_e2767 > 0i)))];
let _e2773 = local_4;
let _e2776 = local_5;
let _e2777 = (_e2765 + _e2776);
let _e2779 = select(_e1282, _e2777, (_e2777 < _e1282));
let _e2784 = global_8.member[bitcast<u32>(select(0i, _e2779, (_e2779 > 0i)))];
let _e2785 = local_4;
let _e2790 = (_e2740 + (((_e2732 - _e2702) * _e2379) * _e2384));
let _e2792 = select(_e1282, _e2790, (_e2790 < _e1282));
let _e2797 = global_8.member[bitcast<u32>(select(0i, _e2792, (_e2792 > 0i)))];
let _e2798 = local_4;
let _e2801 = local_5;
let _e2802 = (_e2790 + _e2801);
let _e2804 = select(_e1282, _e2802, (_e2802 < _e1282));
let _e2809 = global_8.member[bitcast<u32>(select(0i, _e2804, (_e2804 > 0i)))];
let _e2810 = local_4;
let _e2814 = (_e2790 + _e2725);
let _e2816 = select(_e1282, _e2814, (_e2814 < _e1282));
let _e2821 = global_8.member[bitcast<u32>(select(0i, _e2816, (_e2816 > 0i)))];
let _e2822 = local_4;
let _e2825 = local_5;
let _e2826 = (_e2814 + _e2825);
let _e2828 = select(_e1282, _e2826, (_e2826 < _e1282));
let _e2833 = global_8.member[bitcast<u32>(select(0i, _e2828, (_e2828 > 0i)))];
let _e2834 = local_4;
phi_4206_ = (_e2354 + 1u);
phi_4209_ = (_e2356 + ((0.5f * (((((((_e2531 * (1f - _e2532)) + (_e2543 * _e2544)) * _e2547) + (((_e2556 * (1f - _e2557)) + (_e2568 * _e2569)) * _e2485)) * (1f - _e2487)) + (((((_e2581 * (1f - _e2582)) + (_e2593 * _e2594)) * _e2547) + (((_e2605 * (1f - _e2606)) + (_e2617 * _e2618)) * _e2485)) * _e2487)) + ((((((_e2747 * (1f - _e2748)) + (_e2759 * _e2760)) * _e2763) + (((_e2772 * (1f - _e2773)) + (_e2784 * _e2785)) * _e2706)) * (1f - _e2708)) + (((((_e2797 * (1f - _e2798)) + (_e2809 * _e2810)) * _e2763) + (((_e2821 * (1f - _e2822)) + (_e2833 * _e2834)) * _e2706)) * _e2708)))) * _e2366));
} else {
phi_4206_ = u32();
phi_4209_ = f32();
}
let _e2849 = phi_4206_;
let _e2851 = phi_4209_;
continue;
continuing {
phi_4205_ = _e2849;
phi_4208_ = _e2851;
break if !(_e2359);
}
}
let _e3992 = local_33;
phi_4918_ = _e3992;
}
let _e2854 = phi_4918_;
let _e2867 = (0.25f * bitcast<f32>((bitcast<u32>((((_e1259.member_2.x * _e1759) + (_e1259.member_2.y * _e1772)) + (_e1259.member_2.z * _e1785))) & 2147483647u)));
let _e2874 = (((_e1259.member_1.x * _e461) + (_e1259.member_1.y * _e472)) + (_e1259.member_1.z * _e483));
let _e2876 = select(1f, -1f, (_e2874 > 0f));
let _e2884 = select(_e2876, -(_e2876), ((((_e1259.member_2.x * _e1259.member_1.x) + (_e1259.member_2.y * _e1259.member_1.y)) + (_e1259.member_2.z * _e1259.member_1.z)) < 0f));
let _e2885 = (_e1259.member_2.x * _e2884);
let _e2886 = (_e1259.member_2.y * _e2884);
let _e2887 = (_e1259.member_2.z * _e2884);
let _e2896 = ((((_e2885 * _e461) + (_e2886 * _e472)) + (_e2887 * _e483)) > 0f);
let _e2905 = -((((select(_e2885, (_e1259.member_1.x * _e2876), _e2896) * _e1759) + (select(_e2886, (_e1259.member_1.y * _e2876), _e2896) * _e1772)) + (select(_e2887, (_e1259.member_1.z * _e2876), _e2896) * _e1785)));
let _e2910 = -(_e2905);
let _e2920 = global_1.member.member_13.member;
let _e2925 = -((_e2920.member * _e2854));
let _e2927 = select(-87f, _e2925, (_e2925 > -87f));
let _e2929 = select(88f, _e2927, (_e2927 < 88f));
let _e2931 = ((_e2929 * 1.442695f) + 0.5f);
let _e2933 = select(-127f, _e2931, (_e2931 > -127f));
let _e2935 = select(128f, _e2933, (_e2933 < 128f));
let _e2942 = select(0i, select(select(i32(_e2935), i32(-2147483648), (_e2935 < -2147483600f)), 2147483647i, (_e2935 > 2147483500f)), (_e2935 == _e2935));
let _e2946 = (_e2942 - select(0i, 1i, (_e2935 < f32(_e2942))));
let _e2947 = f32(_e2946);
let _e2951 = ((_e2929 - (_e2947 * 0.6933594f)) - (_e2947 * -2.1219444e-4f));
let _e2973 = -((_e2920.member_1 * _e2854));
let _e2975 = select(-87f, _e2973, (_e2973 > -87f));
let _e2977 = select(88f, _e2975, (_e2975 < 88f));
let _e2979 = ((_e2977 * 1.442695f) + 0.5f);
let _e2981 = select(-127f, _e2979, (_e2979 > -127f));
let _e2983 = select(128f, _e2981, (_e2981 < 128f));
let _e2990 = select(0i, select(select(i32(_e2983), i32(-2147483648), (_e2983 < -2147483600f)), 2147483647i, (_e2983 > 2147483500f)), (_e2983 == _e2983));
let _e2994 = (_e2990 - select(0i, 1i, (_e2983 < f32(_e2990))));
let _e2995 = f32(_e2994);
let _e2999 = ((_e2977 - (_e2995 * 0.6933594f)) - (_e2995 * -2.1219444e-4f));
let _e3021 = -((_e2920.member_2 * _e2854));
let _e3023 = select(-87f, _e3021, (_e3021 > -87f));
let _e3025 = select(88f, _e3023, (_e3023 < 88f));
let _e3027 = ((_e3025 * 1.442695f) + 0.5f);
let _e3029 = select(-127f, _e3027, (_e3027 > -127f));
let _e3031 = select(128f, _e3029, (_e3029 < 128f));
let _e3038 = select(0i, select(select(i32(_e3031), i32(-2147483648), (_e3031 < -2147483600f)), 2147483647i, (_e3031 > 2147483500f)), (_e3031 == _e3031));
let _e3042 = (_e3038 - select(0i, 1i, (_e3031 < f32(_e3038))));
let _e3043 = f32(_e3042);
let _e3047 = ((_e3025 - (_e3043 * 0.6933594f)) - (_e3043 * -2.1219444e-4f));
let _e3073 = ((((((select(_e2265, (1f - _e2265), (_e2250 >= 0f)) - select(_e2284, (1f - _e2284), (_e2269 >= 0f))) * (1f / _e2215)) * ((select(_e2316, (1f - _e2316), (_e2301 >= 0f)) - select(_e2335, (1f - _e2335), (_e2320 >= 0f))) * (1f / _e2225))) / _e2105) * (select((select(0f, _e2910, (_e2910 > 0f)) * _e1259.member_4), select(0f, _e2905, (_e2905 > 0f)), ((_e2011 * _e2874) > 0f)) / select(_e2867, _e2014, (_e2014 > _e2867)))) * (1f / 3.1415927f));
phi_5251_ = vec3<f32>(((_e1954 * ((1f + (_e2951 * (1f + (_e2951 * (0.5f + (_e2951 * (0.16666667f + (_e2951 * (0.041666668f + (_e2951 * (0.008333334f + (_e2951 * (0.001388889f + (_e2951 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2946 + 127i)) << bitcast<u32>(23i))))) * _e3073), ((_e1967 * ((1f + (_e2999 * (1f + (_e2999 * (0.5f + (_e2999 * (0.16666667f + (_e2999 * (0.041666668f + (_e2999 * (0.008333334f + (_e2999 * (0.001388889f + (_e2999 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2994 + 127i)) << bitcast<u32>(23i))))) * _e3073), ((_e1980 * ((1f + (_e3047 * (1f + (_e3047 * (0.5f + (_e3047 * (0.16666667f + (_e3047 * (0.041666668f + (_e3047 * (0.008333334f + (_e3047 * (0.001388889f + (_e3047 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3042 + 127i)) << bitcast<u32>(23i))))) * _e3073));
}
let _e3079 = phi_5251_;
phi_5252_ = _e3079;
phi_5253_ = _e2238;
}
let _e3081 = phi_5252_;
let _e3083 = phi_5253_;
phi_5257_ = _e3081;
phi_5258_ = _e3083;
}
let _e3085 = phi_5257_;
let _e3087 = phi_5258_;
phi_5262_ = _e3085;
phi_5263_ = _e3087;
}
let _e3089 = phi_5262_;
let _e3091 = phi_5263_;
phi_5279_ = (_e1522 + select(_e3089, vec3<f32>(0f, 0f, 0f), vec3(_e3091)));
} else {
phi_5279_ = _e1522;
}
let _e3096 = phi_5279_;
let _e3097 = local_14.member_1;
phi_5287_ = type_17(_e1524.member, (_e1524.member_1 + 1u));
loop {
let _e3101 = phi_5287_;
local_34 = _e3101;
let _e3107 = (((_e3101.member_1 & 3u) == 0u) && (_e3101.member < _e3097));
if _e3107 {
phi_5288_ = type_17((_e3101.member + 1u), (_e3101.member_1 >> bitcast<u32>(2i)));
} else {
phi_5288_ = type_17();
}
let _e3113 = phi_5288_;
continue;
continuing {
phi_5287_ = _e3113;
break if !(_e3107);
}
}
phi_5309_ = _e3096;
let _e4006 = local_34;
phi_5310_ = _e4006;
}
let _e3120 = phi_5309_;
let _e3122 = phi_5310_;
phi_2749_ = _e3120;
phi_2752_ = _e3122;
} else {
phi_2749_ = vec3<f32>();
phi_2752_ = type_17();
}
let _e3124 = phi_2749_;
let _e3126 = phi_2752_;
continue;
continuing {
phi_2748_ = _e3124;
phi_2751_ = _e3126;
break if !(_e1532);
}
}
let _e4011 = local_35;
phi_2552_ = _e4011;
phi_2555_ = (_e1356 + 1u);
} else {
phi_2552_ = vec3<f32>();
phi_2555_ = u32();
}
let _e3130 = phi_2552_;
let _e3132 = phi_2555_;
continue;
continuing {
phi_2551_ = _e3130;
phi_2554_ = _e3132;
break if !(_e1361);
}
}
let _e3141 = (1f / select(_e461, select(1e-12f, -1e-12f, (_e461 < 0f)), (bitcast<f32>((bitcast<u32>(_e461) & 2147483647u)) < 1e-12f)));
let _e3149 = (1f / select(_e472, select(1e-12f, -1e-12f, (_e472 < 0f)), (bitcast<f32>((bitcast<u32>(_e472) & 2147483647u)) < 1e-12f)));
let _e3157 = (1f / select(_e483, select(1e-12f, -1e-12f, (_e483 < 0f)), (bitcast<f32>((bitcast<u32>(_e483) & 2147483647u)) < 1e-12f)));
let _e3161 = global_1.member.member_13.member_4;
let _e3168 = global_1.member.member_13.member_5;
let _e3173 = ((_e3161.member - _e778) * _e3141);
let _e3175 = ((_e3168.member - _e778) * _e3141);
let _e3177 = ((_e3161.member_1 - _e779) * _e3149);
let _e3179 = ((_e3168.member_1 - _e779) * _e3149);
let _e3181 = ((_e3161.member_2 - _e780) * _e3157);
let _e3183 = ((_e3168.member_2 - _e780) * _e3157);
let _e3185 = select(_e3175, _e3173, (_e3173 < _e3175));
let _e3187 = select(_e3179, _e3177, (_e3177 < _e3179));
let _e3189 = select(_e3187, _e3185, (_e3185 > _e3187));
let _e3191 = select(_e3183, _e3181, (_e3181 < _e3183));
let _e3193 = select(_e3191, _e3189, (_e3189 > _e3191));
let _e3195 = select(_e3175, _e3173, (_e3173 > _e3175));
let _e3197 = select(_e3179, _e3177, (_e3177 > _e3179));
let _e3199 = select(_e3197, _e3195, (_e3195 < _e3197));
let _e3201 = select(_e3183, _e3181, (_e3181 > _e3183));
let _e3203 = select(_e3201, _e3199, (_e3199 < _e3201));
let _e3205 = select(0f, _e3193, (_e3193 > 0f));
let _e3207 = select(_e781, _e3203, (_e3203 < _e781));
let _e3208 = (_e3207 > _e3205);
let _e3209 = select(0f, _e3205, _e3208);
let _e3211 = (select(0f, _e3207, _e3208) - _e3209);
let _e3215 = global_1.member.member_13.member_6;
if (_e3215 == 0u) {
phi_6172_ = _e3211;
} else {
let _e3218 = (_e3211 / f32(_e3215));
phi_5459_ = 0u;
phi_5462_ = 0f;
loop {
let _e3220 = phi_5459_;
let _e3222 = phi_5462_;
local_36 = _e3222;
let _e3225 = ((_e3220 < _e3215) && (_e3211 > 0f));
if _e3225 {
let _e3228 = (_e3209 + (_e3218 * f32(_e3220)));
let _e3229 = (_e3228 + _e3218);
let _e3231 = (0.5f * (_e3228 + _e3229));
let _e3232 = (_e3229 - _e3228);
let _e3233 = (0.28867513f * _e3232);
let _e3234 = (_e3231 - _e3233);
let _e3244 = global_1.member.member_13.member_7;
let _e3245 = bitcast<i32>(_e3244);
let _e3249 = global_1.member.member_13.member_8;
let _e3250 = bitcast<i32>(_e3249);
let _e3254 = global_1.member.member_13.member_9;
let _e3255 = bitcast<i32>(_e3254);
let _e3256 = f32(_e3245);
let _e3258 = (_e3168.member - _e3161.member);
let _e3261 = (((((_e778 + (_e461 * _e3234)) - _e3161.member) / _e3258) * _e3256) - 0.5f);
let _e3262 = (_e3256 - 1f);
let _e3264 = select(0f, _e3261, (_e3261 > 0f));
let _e3266 = select(_e3262, _e3264, (_e3264 < _e3262));
let _e3267 = f32(_e3250);
let _e3269 = (_e3168.member_1 - _e3161.member_1);
let _e3272 = (((((_e779 + (_e472 * _e3234)) - _e3161.member_1) / _e3269) * _e3267) - 0.5f);
let _e3273 = (_e3267 - 1f);
let _e3275 = select(0f, _e3272, (_e3272 > 0f));
let _e3277 = select(_e3273, _e3275, (_e3275 < _e3273));
let _e3278 = f32(_e3255);
let _e3280 = (_e3168.member_2 - _e3161.member_2);
let _e3283 = (((((_e780 + (_e483 * _e3234)) - _e3161.member_2) / _e3280) * _e3278) - 0.5f);
let _e3284 = (_e3278 - 1f);
let _e3286 = select(0f, _e3283, (_e3283 > 0f));
let _e3288 = select(_e3284, _e3286, (_e3286 < _e3284));
let _e3290 = select(0f, _e3266, (_e3266 > 0f));
let _e3292 = select(1e6f, _e3290, (_e3290 < 1e6f));
let _e3299 = select(0i, select(select(i32(_e3292), i32(-2147483648), (_e3292 < -2147483600f)), 2147483647i, (_e3292 > 2147483500f)), (_e3292 == _e3292));
let _e3303 = (_e3299 - select(0i, 1i, (_e3292 < f32(_e3299))));
let _e3305 = select(0f, _e3277, (_e3277 > 0f));
let _e3307 = select(1e6f, _e3305, (_e3305 < 1e6f));
let _e3314 = select(0i, select(select(i32(_e3307), i32(-2147483648), (_e3307 < -2147483600f)), 2147483647i, (_e3307 > 2147483500f)), (_e3307 == _e3307));
let _e3318 = (_e3314 - select(0i, 1i, (_e3307 < f32(_e3314))));
let _e3320 = select(0f, _e3288, (_e3288 > 0f));
let _e3322 = select(1e6f, _e3320, (_e3320 < 1e6f));
let _e3329 = select(0i, select(select(i32(_e3322), i32(-2147483648), (_e3322 < -2147483600f)), 2147483647i, (_e3322 > 2147483500f)), (_e3322 == _e3322));
let _e3333 = (_e3329 - select(0i, 1i, (_e3322 < f32(_e3329))));
let _e3337 = (_e3277 - f32(_e3318));
let _e3339 = (_e3288 - f32(_e3333));
local_2 = (_e3266 - f32(_e3303));
let _e3340 = (_e3303 + 1i);
let _e3342 = select(_e3340, 0i, (_e3340 < 0i));
if (_e3342 >= _e3245) {
phi_5597_ = (_e3245 - 1i);
} else {
phi_5597_ = _e3342;
}
let _e3346 = phi_5597_;
local_3 = (_e3346 - _e3303);
let _e3348 = (_e3318 + 1i);
let _e3350 = select(_e3348, 0i, (_e3348 < 0i));
if (_e3350 >= _e3250) {
phi_5610_ = (_e3250 - 1i);
} else {
phi_5610_ = _e3350;
}
let _e3354 = phi_5610_;
let _e3356 = ((_e3354 - _e3318) * _e3245);
let _e3357 = (_e3333 + 1i);
let _e3359 = select(_e3357, 0i, (_e3357 < 0i));
if (_e3359 >= _e3255) {
phi_5624_ = (_e3255 - 1i);
} else {
phi_5624_ = _e3359;
}
let _e3363 = phi_5624_;
let _e3370 = global_1.member.member_13.member_10;
let _e3371 = bitcast<i32>(_e3370);
let _e3376 = ((_e3371 + (((_e3333 * _e3250) + _e3318) * _e3245)) + _e3303);
let _e3378 = select(_e1282, _e3376, (_e3376 < _e1282));
let _e3383 = global_8.member[bitcast<u32>(select(0i, _e3378, (_e3378 > 0i)))];
let _e3384 = local_2;
let _e3387 = local_3;
let _e3388 = (_e3376 + _e3387);
let _e3390 = select(_e1282, _e3388, (_e3388 < _e1282));
let _e3395 = global_8.member[bitcast<u32>(select(0i, _e3390, (_e3390 > 0i)))];
let _e3396 = local_2;
let _e3399 = (1f - _e3337);
let _e3401 = (_e3376 + _e3356);
let _e3403 = select(_e1282, _e3401, (_e3401 < _e1282));
let _e3408 = global_8.member[bitcast<u32>(select(0i, _e3403, (_e3403 > 0i)))];
let _e3409 = local_2;
let _e3412 = local_3;
let _e3413 = (_e3401 + _e3412);
let _e3415 = select(_e1282, _e3413, (_e3413 < _e1282));
let _e3420 = global_8.member[bitcast<u32>(select(0i, _e3415, (_e3415 > 0i)))];
let _e3421 = local_2;
let _e3426 = (_e3376 + (((_e3363 - _e3333) * _e3245) * _e3250));
let _e3428 = select(_e1282, _e3426, (_e3426 < _e1282));
let _e3433 = global_8.member[bitcast<u32>(select(0i, _e3428, (_e3428 > 0i)))];
let _e3434 = local_2;
let _e3437 = local_3;
let _e3438 = (_e3426 + _e3437);
let _e3440 = select(_e1282, _e3438, (_e3438 < _e1282));
let _e3445 = global_8.member[bitcast<u32>(select(0i, _e3440, (_e3440 > 0i)))];
let _e3446 = local_2;
let _e3450 = (_e3426 + _e3356);
let _e3452 = select(_e1282, _e3450, (_e3450 < _e1282));
let _e3457 = global_8.member[bitcast<u32>(select(0i, _e3452, (_e3452 > 0i)))];
let _e3458 = local_2;
let _e3461 = local_3;
let _e3462 = (_e3450 + _e3461);
let _e3464 = select(_e1282, _e3462, (_e3462 < _e1282));
let _e3469 = global_8.member[bitcast<u32>(select(0i, _e3464, (_e3464 > 0i)))];
let _e3470 = local_2;
let _e3479 = (_e3231 + _e3233);
let _e3489 = (((((_e778 + (_e461 * _e3479)) - _e3161.member) / _e3258) * _e3256) - 0.5f);
let _e3491 = select(0f, _e3489, (_e3489 > 0f));
let _e3493 = select(_e3262, _e3491, (_e3491 < _e3262));
let _e3497 = (((((_e779 + (_e472 * _e3479)) - _e3161.member_1) / _e3269) * _e3267) - 0.5f);
let _e3499 = select(0f, _e3497, (_e3497 > 0f));
let _e3501 = select(_e3273, _e3499, (_e3499 < _e3273));
let _e3505 = (((((_e780 + (_e483 * _e3479)) - _e3161.member_2) / _e3280) * _e3278) - 0.5f);
let _e3507 = select(0f, _e3505, (_e3505 > 0f));
let _e3509 = select(_e3284, _e3507, (_e3507 < _e3284));
let _e3511 = select(0f, _e3493, (_e3493 > 0f));
let _e3513 = select(1e6f, _e3511, (_e3511 < 1e6f));
let _e3520 = select(0i, select(select(i32(_e3513), i32(-2147483648), (_e3513 < -2147483600f)), 2147483647i, (_e3513 > 2147483500f)), (_e3513 == _e3513));
let _e3524 = (_e3520 - select(0i, 1i, (_e3513 < f32(_e3520))));
let _e3526 = select(0f, _e3501, (_e3501 > 0f));
let _e3528 = select(1e6f, _e3526, (_e3526 < 1e6f));
let _e3535 = select(0i, select(select(i32(_e3528), i32(-2147483648), (_e3528 < -2147483600f)), 2147483647i, (_e3528 > 2147483500f)), (_e3528 == _e3528));
let _e3539 = (_e3535 - select(0i, 1i, (_e3528 < f32(_e3535))));
let _e3541 = select(0f, _e3509, (_e3509 > 0f));
let _e3543 = select(1e6f, _e3541, (_e3541 < 1e6f));
let _e3550 = select(0i, select(select(i32(_e3543), i32(-2147483648), (_e3543 < -2147483600f)), 2147483647i, (_e3543 > 2147483500f)), (_e3543 == _e3543));
let _e3554 = (_e3550 - select(0i, 1i, (_e3543 < f32(_e3550))));
let _e3558 = (_e3501 - f32(_e3539));
let _e3560 = (_e3509 - f32(_e3554));
local = (_e3493 - f32(_e3524));
let _e3561 = (_e3524 + 1i);
let _e3563 = select(_e3561, 0i, (_e3561 < 0i));
if (_e3563 >= _e3245) {
phi_5940_ = (_e3245 - 1i);
} else {
phi_5940_ = _e3563;
}
let _e3567 = phi_5940_;
local_1 = (_e3567 - _e3524);
let _e3569 = (_e3539 + 1i);
let _e3571 = select(_e3569, 0i, (_e3569 < 0i));
if (_e3571 >= _e3250) {
phi_5953_ = (_e3250 - 1i);
} else {
phi_5953_ = _e3571;
}
let _e3575 = phi_5953_;
let _e3577 = ((_e3575 - _e3539) * _e3245);
let _e3578 = (_e3554 + 1i);
let _e3580 = select(_e3578, 0i, (_e3578 < 0i));
if (_e3580 >= _e3255) {
phi_5967_ = (_e3255 - 1i);
} else {
phi_5967_ = _e3580;
}
let _e3584 = phi_5967_;
let _e3592 = ((_e3371 + (((_e3554 * _e3250) + _e3539) * _e3245)) + _e3524);
let _e3594 = select(_e1282, _e3592, (_e3592 < _e1282));
let _e3599 = global_8.member[bitcast<u32>(select(0i, _e3594, (_e3594 > 0i)))];
let _e3600 = local;
let _e3603 = local_1;
let _e3604 = (_e3592 + _e3603);
let _e3606 = select(_e1282, _e3604, (_e3604 < _e1282));
let _e3611 = global_8.member[bitcast<u32>(select(0i, _e3606, (_e3606 > 0i)))];
let _e3612 = local;
let _e3615 = (1f - _e3558);
let _e3617 = (_e3592 + _e3577);
let _e3619 = select(_e1282, _e3617, (_e3617 < _e1282));
let _e3624 = global_8.member[bitcast<u32>(select(0i, _e3619, (_e3619 > 0i)))];
let _e3625 = local;
let _e3628 = local_1;
let _e3629 = (_e3617 + _e3628);
let _e3631 = select(_e1282, _e3629, (_e3629 < _e1282));
let _e3636 = global_8.member[bitcast<u32>(select(0i, _e3631, (_e3631 > 0i)))];
let _e3637 = local;
let _e3642 = (_e3592 + (((_e3584 - _e3554) * _e3245) * _e3250));
let _e3644 = select(_e1282, _e3642, (_e3642 < _e1282));
let _e3649 = global_8.member[bitcast<u32>(select(0i, _e3644, (_e3644 > 0i)))];
let _e3650 = local;
let _e3653 = local_1;
let _e3654 = (_e3642 + _e3653);
let _e3656 = select(_e1282, _e3654, (_e3654 < _e1282));
let _e3661 = global_8.member[bitcast<u32>(select(0i, _e3656, (_e3656 > 0i)))];
let _e3662 = local;
let _e3666 = (_e3642 + _e3577);
let _e3668 = select(_e1282, _e3666, (_e3666 < _e1282));
let _e3673 = global_8.member[bitcast<u32>(select(0i, _e3668, (_e3668 > 0i)))];
let _e3674 = local;
let _e3677 = local_1;
let _e3678 = (_e3666 + _e3677);
let _e3680 = select(_e1282, _e3678, (_e3678 < _e1282));
let _e3685 = global_8.member[bitcast<u32>(select(0i, _e3680, (_e3680 > 0i)))];
let _e3686 = local;
phi_5460_ = (_e3220 + 1u);
phi_5463_ = (_e3222 + ((0.5f * (((((((_e3383 * (1f - _e3384)) + (_e3395 * _e3396)) * _e3399) + (((_e3408 * (1f - _e3409)) + (_e3420 * _e3421)) * _e3337)) * (1f - _e3339)) + (((((_e3433 * (1f - _e3434)) + (_e3445 * _e3446)) * _e3399) + (((_e3457 * (1f - _e3458)) + (_e3469 * _e3470)) * _e3337)) * _e3339)) + ((((((_e3599 * (1f - _e3600)) + (_e3611 * _e3612)) * _e3615) + (((_e3624 * (1f - _e3625)) + (_e3636 * _e3637)) * _e3558)) * (1f - _e3560)) + (((((_e3649 * (1f - _e3650)) + (_e3661 * _e3662)) * _e3615) + (((_e3673 * (1f - _e3674)) + (_e3685 * _e3686)) * _e3558)) * _e3560)))) * _e3232));
} else {
phi_5460_ = u32();
phi_5463_ = f32();
}
let _e3701 = phi_5460_;
let _e3703 = phi_5463_;
continue;
continuing {
phi_5459_ = _e3701;
phi_5462_ = _e3703;
break if !(_e3225);
}
}
let _e4025 = local_36;
phi_6172_ = _e4025;
}
let _e3706 = phi_6172_;
let _e3710 = global_1.member.member_13.member;
let _e3715 = -((_e3710.member * _e3706));
let _e3717 = select(-87f, _e3715, (_e3715 > -87f));
let _e3719 = select(88f, _e3717, (_e3717 < 88f));
let _e3721 = ((_e3719 * 1.442695f) + 0.5f);
let _e3723 = select(-127f, _e3721, (_e3721 > -127f));
let _e3725 = select(128f, _e3723, (_e3723 < 128f));
let _e3732 = select(0i, select(select(i32(_e3725), i32(-2147483648), (_e3725 < -2147483600f)), 2147483647i, (_e3725 > 2147483500f)), (_e3725 == _e3725));
let _e3736 = (_e3732 - select(0i, 1i, (_e3725 < f32(_e3732))));
let _e3737 = f32(_e3736);
let _e3741 = ((_e3719 - (_e3737 * 0.6933594f)) - (_e3737 * -2.1219444e-4f));
let _e3763 = -((_e3710.member_1 * _e3706));
let _e3765 = select(-87f, _e3763, (_e3763 > -87f));
let _e3767 = select(88f, _e3765, (_e3765 < 88f));
let _e3769 = ((_e3767 * 1.442695f) + 0.5f);
let _e3771 = select(-127f, _e3769, (_e3769 > -127f));
let _e3773 = select(128f, _e3771, (_e3771 < 128f));
let _e3780 = select(0i, select(select(i32(_e3773), i32(-2147483648), (_e3773 < -2147483600f)), 2147483647i, (_e3773 > 2147483500f)), (_e3773 == _e3773));
let _e3784 = (_e3780 - select(0i, 1i, (_e3773 < f32(_e3780))));
let _e3785 = f32(_e3784);
let _e3789 = ((_e3767 - (_e3785 * 0.6933594f)) - (_e3785 * -2.1219444e-4f));
let _e3811 = -((_e3710.member_2 * _e3706));
let _e3813 = select(-87f, _e3811, (_e3811 > -87f));
let _e3815 = select(88f, _e3813, (_e3813 < 88f));
let _e3817 = ((_e3815 * 1.442695f) + 0.5f);
let _e3819 = select(-127f, _e3817, (_e3817 > -127f));
let _e3821 = select(128f, _e3819, (_e3819 < 128f));
let _e3828 = select(0i, select(select(i32(_e3821), i32(-2147483648), (_e3821 < -2147483600f)), 2147483647i, (_e3821 > 2147483500f)), (_e3821 == _e3821));
let _e3832 = (_e3828 - select(0i, 1i, (_e3821 < f32(_e3828))));
let _e3833 = f32(_e3832);
let _e3837 = ((_e3815 - (_e3833 * 0.6933594f)) - (_e3833 * -2.1219444e-4f));
let _e3860 = local_30;
let _e3865 = local_31;
let _e3870 = local_32;
phi_6408_ = array<f32, 19>(_e168, _e178, _e189, (_e200 + (((_e3860.x * _e1259.member_3.x) * ((1f + (_e3741 * (1f + (_e3741 * (0.5f + (_e3741 * (0.16666667f + (_e3741 * (0.041666668f + (_e3741 * (0.008333334f + (_e3741 * (0.001388889f + (_e3741 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3736 + 127i)) << bitcast<u32>(23i))))) * select(_e626, 1f, _e696))), (_e211 + (((_e3865.y * _e1259.member_3.y) * ((1f + (_e3789 * (1f + (_e3789 * (0.5f + (_e3789 * (0.16666667f + (_e3789 * (0.041666668f + (_e3789 * (0.008333334f + (_e3789 * (0.001388889f + (_e3789 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3784 + 127i)) << bitcast<u32>(23i))))) * select(_e637, 1f, _e696))), (_e222 + (((_e3870.z * _e1259.member_3.z) * ((1f + (_e3837 * (1f + (_e3837 * (0.5f + (_e3837 * (0.16666667f + (_e3837 * (0.041666668f + (_e3837 * (0.008333334f + (_e3837 * (0.001388889f + (_e3837 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3832 + 127i)) << bitcast<u32>(23i))))) * select(_e648, 1f, _e696))), _e233, _e244, _e255, _e266, _e277, _e288, _e299, _e310, _e321, _e332, _e343, _e354, _e365);
} else {
phi_6408_ = array<f32, 19>(_e168, _e178, _e189, _e200, _e211, _e222, _e233, _e244, _e255, _e266, _e277, _e288, _e299, _e310, _e321, _e332, _e343, _e354, _e365);
}
let _e3885 = phi_6408_;
global_5.member[_e157] = _e3885[0];
global_5.member[_e169] = _e3885[1];
global_5.member[_e180] = _e3885[2];
global_5.member[_e191] = _e3885[3];
global_5.member[_e202] = _e3885[4];
global_5.member[_e213] = _e3885[5];
global_5.member[_e224] = _e3885[6];
global_5.member[_e235] = _e3885[7];
global_5.member[_e246] = _e3885[8];
global_5.member[_e257] = _e3885[9];
global_5.member[_e268] = _e3885[10];
global_5.member[_e279] = _e3885[11];
global_5.member[_e290] = _e3885[12];
global_5.member[_e301] = _e3885[13];
global_5.member[_e312] = _e3885[14];
global_5.member[_e323] = _e3885[15];
global_5.member[_e334] = _e3885[16];
global_5.member[_e345] = _e3885[17];
global_5.member[_e356] = _e3885[18];
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
