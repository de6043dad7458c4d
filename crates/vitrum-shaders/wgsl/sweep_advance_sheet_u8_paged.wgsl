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
struct type_11 {
member: array<f32>,
}
struct type_16 {
member: array<u32>,
}
struct type_17 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_18 {
member: u32,
member_1: u32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_20 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_21 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_22 {
member: type_5,
member_1: type_5,
}
struct type_23 {
member: type_7,
member_1: u32,
}
struct type_24 {
member: type_2,
member_1: u32,
member_2: type_17,
member_3: type_18,
member_4: u32,
member_5: type_19,
member_6: type_20,
member_7: type_20,
member_8: type_21,
member_9: type_22,
member_10: f32,
member_11: type_19,
member_12: type_4,
member_13: type_9,
member_14: type_23,
member_15: type_23,
member_16: type_23,
member_17: type_23,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_25 {
member: type_24,
}
struct type_28 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_29 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_30 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_25;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(3)
var<storage> global_3: type_16;
@group(0) @binding(4)
var<storage> global_4: type_16;
@group(0) @binding(5)
var<storage> global_5: type_11;
@group(0) @binding(6)
var<storage, read_write> global_6: type_11;
fn function_() {
var local: type_28;
var local_1: vec3<f32>;
var local_2: type_28;
var local_3: vec3<f32>;
var local_4: type_28;
var local_5: vec3<f32>;
var phi_3829_: type_29;
var phi_4531_: type_30;
var phi_5456_: type_5;
var phi_6482_: vec3<f32>;
var phi_6483_: bool;
switch bitcast<i32>(0u) {
default: {
let _e90 = global;
let _e93 = arrayLength((&global_2.member));
let _e97 = arrayLength((&global_4.member));
let _e104 = global_1.member.member_2;
let _e107 = global_1.member.member;
let _e115 = (_e90.x + _e104.member);
let _e117 = (_e90.y + _e104.member_1);
if (_e115 < _e104.member_2) {
if (_e117 < _e104.member_3) {
let _e120 = (_e107.member * _e107.member_1);
let _e122 = ((_e117 * _e107.member) + _e115);
let _e123 = bitcast<i32>(_e122);
let _e125 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e127 = select(_e125, _e123, (_e123 < _e125));
let _e133 = global_6.member[bitcast<u32>(select(0i, _e127, (_e127 > 0i)))];
let _e134 = (_e120 + _e122);
let _e135 = bitcast<i32>(_e134);
let _e137 = select(_e125, _e135, (_e135 < _e125));
let _e143 = global_6.member[bitcast<u32>(select(0i, _e137, (_e137 > 0i)))];
let _e145 = ((2u * _e120) + _e122);
let _e146 = bitcast<i32>(_e145);
let _e148 = select(_e125, _e146, (_e146 < _e125));
let _e154 = global_6.member[bitcast<u32>(select(0i, _e148, (_e148 > 0i)))];
let _e156 = ((3u * _e120) + _e122);
let _e157 = bitcast<i32>(_e156);
let _e159 = select(_e125, _e157, (_e157 < _e125));
let _e165 = global_6.member[bitcast<u32>(select(0i, _e159, (_e159 > 0i)))];
let _e167 = ((4u * _e120) + _e122);
let _e168 = bitcast<i32>(_e167);
let _e170 = select(_e125, _e168, (_e168 < _e125));
let _e176 = global_6.member[bitcast<u32>(select(0i, _e170, (_e170 > 0i)))];
let _e178 = ((5u * _e120) + _e122);
let _e179 = bitcast<i32>(_e178);
let _e181 = select(_e125, _e179, (_e179 < _e125));
let _e187 = global_6.member[bitcast<u32>(select(0i, _e181, (_e181 > 0i)))];
let _e189 = ((6u * _e120) + _e122);
let _e190 = bitcast<i32>(_e189);
let _e192 = select(_e125, _e190, (_e190 < _e125));
let _e198 = global_6.member[bitcast<u32>(select(0i, _e192, (_e192 > 0i)))];
let _e200 = ((7u * _e120) + _e122);
let _e201 = bitcast<i32>(_e200);
let _e203 = select(_e125, _e201, (_e201 < _e125));
let _e209 = global_6.member[bitcast<u32>(select(0i, _e203, (_e203 > 0i)))];
let _e211 = ((8u * _e120) + _e122);
let _e212 = bitcast<i32>(_e211);
let _e214 = select(_e125, _e212, (_e212 < _e125));
let _e220 = global_6.member[bitcast<u32>(select(0i, _e214, (_e214 > 0i)))];
let _e222 = ((9u * _e120) + _e122);
let _e223 = bitcast<i32>(_e222);
let _e225 = select(_e125, _e223, (_e223 < _e125));
let _e231 = global_6.member[bitcast<u32>(select(0i, _e225, (_e225 > 0i)))];
let _e233 = ((10u * _e120) + _e122);
let _e234 = bitcast<i32>(_e233);
let _e236 = select(_e125, _e234, (_e234 < _e125));
let _e242 = global_6.member[bitcast<u32>(select(0i, _e236, (_e236 > 0i)))];
let _e247 = global_1.member.member_5.member_2;
let _e250 = (1f / select(1e-6f, _e198, (_e198 > 1e-6f)));
let _e254 = global_1.member.member_8.member_5;
let _e255 = (_e247 * _e254);
let _e260 = global_1.member.member_8.member_6;
let _e262 = (((_e176 * _e250) - _e260) * _e255);
let _e267 = global_1.member.member_8.member_7;
let _e269 = (((_e187 * _e250) - _e267) * _e255);
let _e273 = ((f32(bitcast<i32>(_e115)) - 0.5f) + _e133);
let _e277 = global_1.member.member_8.member_1;
let _e278 = (_e277 + 1u);
let _e280 = select(1u, _e278, (_e278 > 0u));
let _e281 = (_e280 == 0u);
if _e281 {
break;
}
let _e286 = ((f32(bitcast<i32>((_e117 % _e280))) - 0.5f) + _e143);
let _e290 = global_1.member.member_5.member;
let _e294 = global_1.member.member_8.member_8;
let _e295 = (_e290 - _e294);
let _e299 = global_1.member.member_8.member_2;
let _e306 = global_1.member.member_8.member_4;
let _e308 = ((_e299 + (_e260 * _e295)) + ((_e273 + 0.5f) * _e306));
let _e312 = global_1.member.member_8.member_3;
let _e317 = ((_e312 + (_e267 * _e295)) + ((_e286 + 0.5f) * _e306));
let _e323 = global_1.member.member_5.member_1;
let _e324 = (_e323 - _e294);
let _e329 = ((_e299 + (_e260 * _e324)) + (((_e273 + _e262) + 0.5f) * _e306));
let _e334 = ((_e312 + (_e267 * _e324)) + (((_e286 + _e269) + 0.5f) * _e306));
if _e281 {
break;
}
let _e337 = bitcast<i32>(((_e117 / _e280) * 3u));
let _e339 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e341 = select(_e339, _e337, (_e337 < _e339));
let _e347 = global_5.member[bitcast<u32>(select(0i, _e341, (_e341 > 0i)))];
let _e348 = (_e337 + 1i);
let _e350 = select(_e339, _e348, (_e348 < _e339));
let _e356 = global_5.member[bitcast<u32>(select(0i, _e350, (_e350 > 0i)))];
let _e357 = (_e337 + 2i);
let _e359 = select(_e339, _e357, (_e357 < _e339));
let _e365 = global_5.member[bitcast<u32>(select(0i, _e359, (_e359 > 0i)))];
let _e368 = (1f / select(1e-6f, _e365, (_e365 > 1e-6f)));
let _e371 = (((_e347 * _e368) - _e260) * _e255);
let _e374 = (((_e356 * _e368) - _e267) * _e255);
let _e386 = global_1.member.member_6.member;
let _e397 = ((((_e386.member.member * _e308) + (_e386.member.member_1 * _e317)) + (_e386.member.member_2 * _e290)) + _e386.member_1);
let _e401 = global_1.member.member_6.member_1;
let _e412 = ((((_e401.member.member * _e308) + (_e401.member.member_1 * _e317)) + (_e401.member.member_2 * _e290)) + _e401.member_1);
let _e416 = global_1.member.member_6.member_2;
let _e427 = ((((_e416.member.member * _e308) + (_e416.member.member_1 * _e317)) + (_e416.member.member_2 * _e290)) + _e416.member_1);
let _e433 = ((((_e386.member.member * _e329) + (_e386.member.member_1 * _e334)) + (_e386.member.member_2 * _e323)) + _e386.member_1);
let _e439 = ((((_e401.member.member * _e329) + (_e401.member.member_1 * _e334)) + (_e401.member.member_2 * _e323)) + _e401.member_1);
let _e445 = ((((_e416.member.member * _e329) + (_e416.member.member_1 * _e334)) + (_e416.member.member_2 * _e323)) + _e416.member_1);
let _e449 = global_1.member.member_6.member_4;
let _e454 = global_1.member.member_6.member_3.member;
let _e455 = (_e454 - 0.5f);
let _e457 = select(-0.5f, _e433, (_e433 > -0.5f));
let _e459 = select(_e455, _e457, (_e457 < _e455));
let _e464 = global_1.member.member_6.member_3.member_1;
let _e465 = (_e464 - 0.5f);
let _e467 = select(-0.5f, _e439, (_e439 > -0.5f));
let _e469 = select(_e465, _e467, (_e467 < _e465));
let _e474 = global_1.member.member_6.member_3.member_2;
let _e475 = (_e474 - 0.5f);
let _e477 = select(-0.5f, _e445, (_e445 > -0.5f));
let _e479 = select(_e475, _e477, (_e477 < _e475));
let _e480 = (_e433 - _e397);
let _e481 = (_e439 - _e412);
let _e482 = (_e445 - _e427);
let _e485 = bitcast<f32>((bitcast<u32>(_e480) & 2147483647u));
let _e488 = bitcast<f32>((bitcast<u32>(_e481) & 2147483647u));
let _e490 = select(_e488, _e485, (_e485 > _e488));
let _e493 = bitcast<f32>((bitcast<u32>(_e482) & 2147483647u));
let _e502 = bitcast<f32>((bitcast<u32>((_e433 - _e459)) & 2147483647u));
let _e505 = bitcast<f32>((bitcast<u32>((_e439 - _e469)) & 2147483647u));
let _e507 = select(_e505, _e502, (_e502 > _e505));
let _e510 = bitcast<f32>((bitcast<u32>((_e445 - _e479)) & 2147483647u));
let _e514 = (_e459 + 0.5f);
let _e515 = (_e454 - 1f);
let _e517 = select(0f, _e514, (_e514 > 0f));
let _e519 = select(_e515, _e517, (_e517 < _e515));
let _e526 = select(0i, select(select(i32(_e519), i32(-2147483648), (_e519 < -2147483600f)), 2147483647i, (_e519 > 2147483500f)), (_e519 == _e519));
let _e534 = global_1.member.member_6.member_12;
let _e535 = (_e534 & 31u);
let _e538 = (_e469 + 0.5f);
let _e539 = (_e464 - 1f);
let _e541 = select(0f, _e538, (_e538 > 0f));
let _e543 = select(_e539, _e541, (_e541 < _e539));
let _e550 = select(0i, select(select(i32(_e543), i32(-2147483648), (_e543 < -2147483600f)), 2147483647i, (_e543 > 2147483500f)), (_e543 == _e543));
let _e557 = (_e479 + 0.5f);
let _e558 = (_e474 - 1f);
let _e560 = select(0f, _e557, (_e557 > 0f));
let _e562 = select(_e558, _e560, (_e560 < _e558));
let _e569 = select(0i, select(select(i32(_e562), i32(-2147483648), (_e562 < -2147483600f)), 2147483647i, (_e562 > 2147483500f)), (_e562 == _e562));
let _e580 = global_1.member.member_6.member_9.member;
let _e586 = global_1.member.member_6.member_9.member_1;
let _e591 = global_1.member.member_6.member_10;
let _e597 = ((bitcast<i32>(_e591) + ((_e526 - select(0i, 1i, (_e519 < f32(_e526)))) >> bitcast<u32>(_e535))) + (bitcast<i32>(_e580) * (((_e550 - select(0i, 1i, (_e543 < f32(_e550)))) >> bitcast<u32>(_e535)) + (bitcast<i32>(_e586) * ((_e569 - select(0i, 1i, (_e562 < f32(_e569)))) >> bitcast<u32>(_e535))))));
let _e599 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e601 = select(_e599, _e597, (_e597 < _e599));
let _e607 = global_3.member[bitcast<u32>(select(0i, _e601, (_e601 > 0i)))];
let _e613 = global_1.member.member_1;
let _e620 = (((_e613 & 64u) != 0u) || ((((select(_e493, _e490, (_e490 > _e493)) <= _e449) && ((select(_e510, _e507, (_e507 > _e510)) > _e449) || (_e607 != 0u))) && true) && ((_e613 & 32u) != 0u)));
if (select(0u, select(7u, select(3u, 1u, ((((_e262 == 0f) && (_e269 == 0f)) && (_e371 == 0f)) && (_e374 == 0f))), _e620), (_e242 == 0f)) > 1u) {
if _e281 {
break;
}
if _e281 {
break;
}
let _e627 = (_e107.member_2 == 2u);
let _e630 = (((_e107.member_2 == 1u) || _e627) || (_e107.member_2 == 5u));
if _e630 {
let _e632 = select(-1f, _e459, (_e459 > -1f));
let _e634 = select(_e454, _e632, (_e632 < _e454));
let _e641 = select(0i, select(select(i32(_e634), i32(-2147483648), (_e634 < -2147483600f)), 2147483647i, (_e634 > 2147483500f)), (_e634 == _e634));
let _e645 = (_e641 - select(0i, 1i, (_e634 < f32(_e641))));
let _e647 = select(-1f, _e469, (_e469 > -1f));
let _e649 = select(_e464, _e647, (_e647 < _e464));
let _e656 = select(0i, select(select(i32(_e649), i32(-2147483648), (_e649 < -2147483600f)), 2147483647i, (_e649 > 2147483500f)), (_e649 == _e649));
let _e660 = (_e656 - select(0i, 1i, (_e649 < f32(_e656))));
let _e662 = select(-1f, _e479, (_e479 > -1f));
let _e664 = select(_e474, _e662, (_e662 < _e474));
let _e671 = select(0i, select(select(i32(_e664), i32(-2147483648), (_e664 < -2147483600f)), 2147483647i, (_e664 > 2147483500f)), (_e664 == _e664));
let _e675 = (_e671 - select(0i, 1i, (_e664 < f32(_e671))));
let _e679 = global_1.member.member_6.member_7;
let _e683 = global_1.member.member_6.member_8;
let _e684 = (_e645 + 1i);
let _e685 = (_e660 + 1i);
let _e686 = (_e675 + 1i);
let _e691 = global_1.member.member_6.member_11.member;
let _e697 = global_1.member.member_6.member_11.member_1;
let _e708 = ((_e684 >> bitcast<u32>(4i)) + (bitcast<i32>(_e691) * ((_e685 >> bitcast<u32>(4i)) + (bitcast<i32>(_e697) * (_e686 >> bitcast<u32>(4i))))));
let _e710 = (bitcast<i32>(_e93) - 1i);
let _e712 = select(_e710, _e708, (_e708 < _e710));
let _e718 = global_2.member[bitcast<u32>(select(0i, _e712, (_e712 > 0i)))];
let _e720 = (_e684 & 15i);
let _e723 = ((_e685 & 15i) * _e679);
let _e725 = (bitcast<i32>(_e718) + ((_e686 & 15i) * _e683));
let _e726 = (_e723 + _e679);
let _e728 = (_e723 + (2i * _e679));
let _e730 = (_e723 + (3i * _e679));
let _e731 = (_e725 + _e683);
let _e733 = (_e725 + (2i * _e683));
let _e735 = (_e725 + (3i * _e683));
local_4 = type_28(array<i32, 4>(_e720, _e720, _e720, _e720), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_5 = vec3<f32>((_e459 - f32(_e645)), (_e469 - f32(_e660)), (_e479 - f32(_e675)));
let _e749 = local_4.member[0u];
let _e750 = ((_e731 + _e726) + _e749);
let _e752 = (_e750 >> bitcast<u32>(2i));
let _e755 = bitcast<u32>(((_e750 & 3i) * 8i));
let _e757 = select(_e710, _e752, (_e752 < _e710));
let _e762 = global_2.member[bitcast<u32>(select(0i, _e757, (_e757 > 0i)))];
let _e766 = (_e752 + 1i);
let _e768 = select(_e710, _e766, (_e766 < _e710));
let _e773 = global_2.member[bitcast<u32>(select(0i, _e768, (_e768 > 0i)))];
let _e780 = ((_e762 >> bitcast<u32>((_e755 & 31u))) | ((_e773 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e755) & 31u))));
let _e783 = local_4.member_1[0u];
let _e789 = f32(bitcast<i32>(((_e780 >> bitcast<u32>((_e783 & 31u))) & 255u)));
let _e792 = local_4.member_1[1u];
let _e798 = f32(bitcast<i32>(((_e780 >> bitcast<u32>((_e792 & 31u))) & 255u)));
let _e801 = local_4.member_1[2u];
let _e807 = f32(bitcast<i32>(((_e780 >> bitcast<u32>((_e801 & 31u))) & 255u)));
let _e810 = local_4.member_1[3u];
let _e817 = local_5[0u];
let _e820 = (_e789 + ((_e798 - _e789) * _e817));
let _e821 = local_5[0u];
let _e824 = (_e798 + ((_e807 - _e798) * _e821));
let _e825 = local_5[0u];
let _e828 = (_e807 + ((f32(bitcast<i32>(((_e780 >> bitcast<u32>((_e810 & 31u))) & 255u))) - _e807) * _e825));
let _e830 = local_4.member[0u];
let _e831 = ((_e731 + _e728) + _e830);
let _e833 = (_e831 >> bitcast<u32>(2i));
let _e836 = bitcast<u32>(((_e831 & 3i) * 8i));
let _e838 = select(_e710, _e833, (_e833 < _e710));
let _e843 = global_2.member[bitcast<u32>(select(0i, _e838, (_e838 > 0i)))];
let _e847 = (_e833 + 1i);
let _e849 = select(_e710, _e847, (_e847 < _e710));
let _e854 = global_2.member[bitcast<u32>(select(0i, _e849, (_e849 > 0i)))];
let _e861 = ((_e843 >> bitcast<u32>((_e836 & 31u))) | ((_e854 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e836) & 31u))));
let _e862 = local_4.member_1[0u];
let _e868 = f32(bitcast<i32>(((_e861 >> bitcast<u32>((_e862 & 31u))) & 255u)));
let _e869 = local_4.member_1[1u];
let _e875 = f32(bitcast<i32>(((_e861 >> bitcast<u32>((_e869 & 31u))) & 255u)));
let _e876 = local_4.member_1[2u];
let _e882 = f32(bitcast<i32>(((_e861 >> bitcast<u32>((_e876 & 31u))) & 255u)));
let _e883 = local_4.member_1[3u];
let _e890 = local_5[0u];
let _e894 = local_5[0u];
let _e897 = (_e875 + ((_e882 - _e875) * _e894));
let _e898 = local_5[0u];
let _e903 = local_4.member[0u];
let _e904 = ((_e733 + _e726) + _e903);
let _e906 = (_e904 >> bitcast<u32>(2i));
let _e909 = bitcast<u32>(((_e904 & 3i) * 8i));
let _e911 = select(_e710, _e906, (_e906 < _e710));
let _e916 = global_2.member[bitcast<u32>(select(0i, _e911, (_e911 > 0i)))];
let _e920 = (_e906 + 1i);
let _e922 = select(_e710, _e920, (_e920 < _e710));
let _e927 = global_2.member[bitcast<u32>(select(0i, _e922, (_e922 > 0i)))];
let _e934 = ((_e916 >> bitcast<u32>((_e909 & 31u))) | ((_e927 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e909) & 31u))));
let _e935 = local_4.member_1[0u];
let _e941 = f32(bitcast<i32>(((_e934 >> bitcast<u32>((_e935 & 31u))) & 255u)));
let _e942 = local_4.member_1[1u];
let _e948 = f32(bitcast<i32>(((_e934 >> bitcast<u32>((_e942 & 31u))) & 255u)));
let _e949 = local_4.member_1[2u];
let _e955 = f32(bitcast<i32>(((_e934 >> bitcast<u32>((_e949 & 31u))) & 255u)));
let _e956 = local_4.member_1[3u];
let _e963 = local_5[0u];
let _e966 = (_e941 + ((_e948 - _e941) * _e963));
let _e967 = local_5[0u];
let _e970 = (_e948 + ((_e955 - _e948) * _e967));
let _e971 = local_5[0u];
let _e974 = (_e955 + ((f32(bitcast<i32>(((_e934 >> bitcast<u32>((_e956 & 31u))) & 255u))) - _e955) * _e971));
let _e976 = local_4.member[0u];
let _e977 = ((_e733 + _e728) + _e976);
let _e979 = (_e977 >> bitcast<u32>(2i));
let _e982 = bitcast<u32>(((_e977 & 3i) * 8i));
let _e984 = select(_e710, _e979, (_e979 < _e710));
let _e989 = global_2.member[bitcast<u32>(select(0i, _e984, (_e984 > 0i)))];
let _e993 = (_e979 + 1i);
let _e995 = select(_e710, _e993, (_e993 < _e710));
let _e1000 = global_2.member[bitcast<u32>(select(0i, _e995, (_e995 > 0i)))];
let _e1007 = ((_e989 >> bitcast<u32>((_e982 & 31u))) | ((_e1000 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e982) & 31u))));
let _e1008 = local_4.member_1[0u];
let _e1014 = f32(bitcast<i32>(((_e1007 >> bitcast<u32>((_e1008 & 31u))) & 255u)));
let _e1015 = local_4.member_1[1u];
let _e1021 = f32(bitcast<i32>(((_e1007 >> bitcast<u32>((_e1015 & 31u))) & 255u)));
let _e1022 = local_4.member_1[2u];
let _e1028 = f32(bitcast<i32>(((_e1007 >> bitcast<u32>((_e1022 & 31u))) & 255u)));
let _e1029 = local_4.member_1[3u];
let _e1036 = local_5[0u];
let _e1040 = local_5[0u];
let _e1043 = (_e1021 + ((_e1028 - _e1021) * _e1040));
let _e1044 = local_5[0u];
let _e1049 = local_4.member[0u];
let _e1050 = ((_e731 + _e723) + _e1049);
let _e1052 = (_e1050 >> bitcast<u32>(2i));
let _e1055 = bitcast<u32>(((_e1050 & 3i) * 8i));
let _e1057 = select(_e710, _e1052, (_e1052 < _e710));
let _e1062 = global_2.member[bitcast<u32>(select(0i, _e1057, (_e1057 > 0i)))];
let _e1066 = (_e1052 + 1i);
let _e1068 = select(_e710, _e1066, (_e1066 < _e710));
let _e1073 = global_2.member[bitcast<u32>(select(0i, _e1068, (_e1068 > 0i)))];
let _e1080 = ((_e1062 >> bitcast<u32>((_e1055 & 31u))) | ((_e1073 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1055) & 31u))));
let _e1081 = local_4.member_1[1u];
let _e1087 = f32(bitcast<i32>(((_e1080 >> bitcast<u32>((_e1081 & 31u))) & 255u)));
let _e1088 = local_4.member_1[2u];
let _e1095 = local_5[0u];
let _e1098 = (_e1087 + ((f32(bitcast<i32>(((_e1080 >> bitcast<u32>((_e1088 & 31u))) & 255u))) - _e1087) * _e1095));
let _e1100 = local_4.member[0u];
let _e1101 = ((_e731 + _e730) + _e1100);
let _e1103 = (_e1101 >> bitcast<u32>(2i));
let _e1106 = bitcast<u32>(((_e1101 & 3i) * 8i));
let _e1108 = select(_e710, _e1103, (_e1103 < _e710));
let _e1113 = global_2.member[bitcast<u32>(select(0i, _e1108, (_e1108 > 0i)))];
let _e1117 = (_e1103 + 1i);
let _e1119 = select(_e710, _e1117, (_e1117 < _e710));
let _e1124 = global_2.member[bitcast<u32>(select(0i, _e1119, (_e1119 > 0i)))];
let _e1131 = ((_e1113 >> bitcast<u32>((_e1106 & 31u))) | ((_e1124 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1106) & 31u))));
let _e1132 = local_4.member_1[1u];
let _e1138 = f32(bitcast<i32>(((_e1131 >> bitcast<u32>((_e1132 & 31u))) & 255u)));
let _e1139 = local_4.member_1[2u];
let _e1146 = local_5[0u];
let _e1151 = local_4.member[0u];
let _e1152 = ((_e733 + _e723) + _e1151);
let _e1154 = (_e1152 >> bitcast<u32>(2i));
let _e1157 = bitcast<u32>(((_e1152 & 3i) * 8i));
let _e1159 = select(_e710, _e1154, (_e1154 < _e710));
let _e1164 = global_2.member[bitcast<u32>(select(0i, _e1159, (_e1159 > 0i)))];
let _e1168 = (_e1154 + 1i);
let _e1170 = select(_e710, _e1168, (_e1168 < _e710));
let _e1175 = global_2.member[bitcast<u32>(select(0i, _e1170, (_e1170 > 0i)))];
let _e1182 = ((_e1164 >> bitcast<u32>((_e1157 & 31u))) | ((_e1175 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1157) & 31u))));
let _e1183 = local_4.member_1[1u];
let _e1189 = f32(bitcast<i32>(((_e1182 >> bitcast<u32>((_e1183 & 31u))) & 255u)));
let _e1190 = local_4.member_1[2u];
let _e1197 = local_5[0u];
let _e1200 = (_e1189 + ((f32(bitcast<i32>(((_e1182 >> bitcast<u32>((_e1190 & 31u))) & 255u))) - _e1189) * _e1197));
let _e1202 = local_4.member[0u];
let _e1203 = ((_e733 + _e730) + _e1202);
let _e1205 = (_e1203 >> bitcast<u32>(2i));
let _e1208 = bitcast<u32>(((_e1203 & 3i) * 8i));
let _e1210 = select(_e710, _e1205, (_e1205 < _e710));
let _e1215 = global_2.member[bitcast<u32>(select(0i, _e1210, (_e1210 > 0i)))];
let _e1219 = (_e1205 + 1i);
let _e1221 = select(_e710, _e1219, (_e1219 < _e710));
let _e1226 = global_2.member[bitcast<u32>(select(0i, _e1221, (_e1221 > 0i)))];
let _e1233 = ((_e1215 >> bitcast<u32>((_e1208 & 31u))) | ((_e1226 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1208) & 31u))));
let _e1234 = local_4.member_1[1u];
let _e1240 = f32(bitcast<i32>(((_e1233 >> bitcast<u32>((_e1234 & 31u))) & 255u)));
let _e1241 = local_4.member_1[2u];
let _e1248 = local_5[0u];
let _e1253 = local_4.member[0u];
let _e1254 = ((_e725 + _e726) + _e1253);
let _e1256 = (_e1254 >> bitcast<u32>(2i));
let _e1259 = bitcast<u32>(((_e1254 & 3i) * 8i));
let _e1261 = select(_e710, _e1256, (_e1256 < _e710));
let _e1266 = global_2.member[bitcast<u32>(select(0i, _e1261, (_e1261 > 0i)))];
let _e1270 = (_e1256 + 1i);
let _e1272 = select(_e710, _e1270, (_e1270 < _e710));
let _e1277 = global_2.member[bitcast<u32>(select(0i, _e1272, (_e1272 > 0i)))];
let _e1284 = ((_e1266 >> bitcast<u32>((_e1259 & 31u))) | ((_e1277 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1259) & 31u))));
let _e1285 = local_4.member_1[1u];
let _e1291 = f32(bitcast<i32>(((_e1284 >> bitcast<u32>((_e1285 & 31u))) & 255u)));
let _e1292 = local_4.member_1[2u];
let _e1299 = local_5[0u];
let _e1302 = (_e1291 + ((f32(bitcast<i32>(((_e1284 >> bitcast<u32>((_e1292 & 31u))) & 255u))) - _e1291) * _e1299));
let _e1304 = local_4.member[0u];
let _e1305 = ((_e735 + _e726) + _e1304);
let _e1307 = (_e1305 >> bitcast<u32>(2i));
let _e1310 = bitcast<u32>(((_e1305 & 3i) * 8i));
let _e1312 = select(_e710, _e1307, (_e1307 < _e710));
let _e1317 = global_2.member[bitcast<u32>(select(0i, _e1312, (_e1312 > 0i)))];
let _e1321 = (_e1307 + 1i);
let _e1323 = select(_e710, _e1321, (_e1321 < _e710));
let _e1328 = global_2.member[bitcast<u32>(select(0i, _e1323, (_e1323 > 0i)))];
let _e1335 = ((_e1317 >> bitcast<u32>((_e1310 & 31u))) | ((_e1328 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1310) & 31u))));
let _e1336 = local_4.member_1[1u];
let _e1342 = f32(bitcast<i32>(((_e1335 >> bitcast<u32>((_e1336 & 31u))) & 255u)));
let _e1343 = local_4.member_1[2u];
let _e1350 = local_5[0u];
let _e1353 = (_e1342 + ((f32(bitcast<i32>(((_e1335 >> bitcast<u32>((_e1343 & 31u))) & 255u))) - _e1342) * _e1350));
let _e1355 = local_4.member[0u];
let _e1356 = ((_e725 + _e728) + _e1355);
let _e1358 = (_e1356 >> bitcast<u32>(2i));
let _e1361 = bitcast<u32>(((_e1356 & 3i) * 8i));
let _e1363 = select(_e710, _e1358, (_e1358 < _e710));
let _e1368 = global_2.member[bitcast<u32>(select(0i, _e1363, (_e1363 > 0i)))];
let _e1372 = (_e1358 + 1i);
let _e1374 = select(_e710, _e1372, (_e1372 < _e710));
let _e1379 = global_2.member[bitcast<u32>(select(0i, _e1374, (_e1374 > 0i)))];
let _e1386 = ((_e1368 >> bitcast<u32>((_e1361 & 31u))) | ((_e1379 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1361) & 31u))));
let _e1387 = local_4.member_1[1u];
let _e1393 = f32(bitcast<i32>(((_e1386 >> bitcast<u32>((_e1387 & 31u))) & 255u)));
let _e1394 = local_4.member_1[2u];
let _e1401 = local_5[0u];
let _e1406 = local_4.member[0u];
let _e1407 = ((_e735 + _e728) + _e1406);
let _e1409 = (_e1407 >> bitcast<u32>(2i));
let _e1412 = bitcast<u32>(((_e1407 & 3i) * 8i));
let _e1414 = select(_e710, _e1409, (_e1409 < _e710));
let _e1419 = global_2.member[bitcast<u32>(select(0i, _e1414, (_e1414 > 0i)))];
let _e1423 = (_e1409 + 1i);
let _e1425 = select(_e710, _e1423, (_e1423 < _e710));
let _e1430 = global_2.member[bitcast<u32>(select(0i, _e1425, (_e1425 > 0i)))];
let _e1437 = ((_e1419 >> bitcast<u32>((_e1412 & 31u))) | ((_e1430 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1412) & 31u))));
let _e1438 = local_4.member_1[1u];
let _e1444 = f32(bitcast<i32>(((_e1437 >> bitcast<u32>((_e1438 & 31u))) & 255u)));
let _e1445 = local_4.member_1[2u];
let _e1452 = local_5[0u];
let _e1457 = local_5[1u];
let _e1460 = (_e824 + ((_e897 - _e824) * _e1457));
let _e1461 = local_5[1u];
let _e1464 = (_e970 + ((_e1043 - _e970) * _e1461));
let _e1465 = local_5[1u];
let _e1468 = (_e820 + (((_e868 + ((_e875 - _e868) * _e890)) - _e820) * _e1465));
let _e1469 = local_5[1u];
let _e1474 = local_5[2u];
let _e1478 = local_5[1u];
let _e1481 = (_e828 + (((_e882 + ((f32(bitcast<i32>(((_e861 >> bitcast<u32>((_e883 & 31u))) & 255u))) - _e882) * _e898)) - _e828) * _e1478));
let _e1482 = local_5[1u];
let _e1486 = local_5[2u];
let _e1490 = local_5[1u];
let _e1493 = (_e1098 + ((_e824 - _e1098) * _e1490));
let _e1494 = local_5[1u];
let _e1498 = local_5[2u];
let _e1502 = local_5[1u];
let _e1505 = (_e897 + (((_e1138 + ((f32(bitcast<i32>(((_e1131 >> bitcast<u32>((_e1139 & 31u))) & 255u))) - _e1138) * _e1146)) - _e897) * _e1502));
let _e1506 = local_5[1u];
let _e1510 = local_5[2u];
let _e1514 = local_5[1u];
let _e1517 = (_e1302 + (((_e1393 + ((f32(bitcast<i32>(((_e1386 >> bitcast<u32>((_e1394 & 31u))) & 255u))) - _e1393) * _e1401)) - _e1302) * _e1514));
let _e1518 = local_5[2u];
let _e1522 = local_5[1u];
let _e1526 = local_5[2u];
let _e1530 = local_5[2u];
let _e1537 = global_1.member.member_6.member_5;
let _e1542 = global_1.member.member_6.member_6;
let _e1543 = (((_e1460 + ((_e1464 - _e1460) * _e1530)) * _e1537) + _e1542);
let _e1545 = select(0f, _e1543, (_e1543 > 0f));
let _e1547 = select(1f, _e1545, (_e1545 < 1f));
let _e1549 = (((_e1468 + (((_e966 + (((_e1014 + ((_e1021 - _e1014) * _e1036)) - _e966) * _e1469)) - _e1468) * _e1474)) * _e1537) + _e1542);
let _e1551 = select(0f, _e1549, (_e1549 > 0f));
let _e1553 = select(1f, _e1551, (_e1551 < 1f));
let _e1555 = (((_e1481 + (((_e974 + (((_e1028 + ((f32(bitcast<i32>(((_e1007 >> bitcast<u32>((_e1029 & 31u))) & 255u))) - _e1028) * _e1044)) - _e974) * _e1482)) - _e1481) * _e1486)) * _e1537) + _e1542);
let _e1557 = select(0f, _e1555, (_e1555 > 0f));
let _e1559 = select(1f, _e1557, (_e1557 < 1f));
let _e1561 = (((_e1493 + (((_e1200 + ((_e970 - _e1200) * _e1494)) - _e1493) * _e1498)) * _e1537) + _e1542);
let _e1563 = select(0f, _e1561, (_e1561 > 0f));
let _e1565 = select(1f, _e1563, (_e1563 < 1f));
let _e1567 = (((_e1505 + (((_e1043 + (((_e1240 + ((f32(bitcast<i32>(((_e1233 >> bitcast<u32>((_e1241 & 31u))) & 255u))) - _e1240) * _e1248)) - _e1043) * _e1506)) - _e1505) * _e1510)) * _e1537) + _e1542);
let _e1569 = select(0f, _e1567, (_e1567 > 0f));
let _e1571 = select(1f, _e1569, (_e1569 < 1f));
let _e1573 = (((_e1517 + ((_e1460 - _e1517) * _e1518)) * _e1537) + _e1542);
let _e1575 = select(0f, _e1573, (_e1573 > 0f));
let _e1577 = select(1f, _e1575, (_e1575 < 1f));
let _e1579 = (((_e1464 + (((_e1353 + (((_e1444 + ((f32(bitcast<i32>(((_e1437 >> bitcast<u32>((_e1445 & 31u))) & 255u))) - _e1444) * _e1452)) - _e1353) * _e1522)) - _e1464) * _e1526)) * _e1537) + _e1542);
let _e1581 = select(0f, _e1579, (_e1579 > 0f));
let _e1583 = select(1f, _e1581, (_e1581 < 1f));
let _e1584 = (_e1547 * 1024f);
let _e1585 = (1024f - 1f);
let _e1587 = select(0f, _e1584, (_e1584 > 0f));
let _e1589 = select(_e1585, _e1587, (_e1587 < _e1585));
let _e1596 = select(0i, select(select(i32(_e1589), i32(-2147483648), (_e1589 < -2147483600f)), 2147483647i, (_e1589 > 2147483500f)), (_e1589 == _e1589));
let _e1600 = (_e1596 - select(0i, 1i, (_e1589 < f32(_e1596))));
let _e1601 = (262147i + _e1600);
let _e1603 = (bitcast<i32>(_e97) - 1i);
let _e1605 = select(_e1603, _e1601, (_e1601 < _e1603));
let _e1611 = global_4.member[bitcast<u32>(select(0i, _e1605, (_e1605 > 0i)))];
let _e1621 = select(_e1603, 262146i, (262146i < _e1603));
let _e1627 = global_4.member[bitcast<u32>(select(0i, _e1621, (_e1621 > 0i)))];
let _e1628 = bitcast<f32>(_e1627);
let _e1629 = (f32((bitcast<i32>((_e1611 & 4095u)) - 2048i)) * _e1628);
let _e1631 = select(_e1603, 262144i, (262144i < _e1603));
let _e1637 = global_4.member[bitcast<u32>(select(0i, _e1631, (_e1631 > 0i)))];
let _e1638 = bitcast<f32>(_e1637);
let _e1640 = select(_e1603, 262145i, (262145i < _e1603));
let _e1646 = global_4.member[bitcast<u32>(select(0i, _e1640, (_e1640 > 0i)))];
let _e1647 = bitcast<f32>(_e1646);
let _e1653 = ((_e1638 + (f32(bitcast<i32>((_e1611 >> bitcast<u32>(12u)))) * _e1647)) + (_e1629 * (_e1584 - f32(_e1600))));
let _e1654 = (_e1629 * 1024f);
if _e627 {
let _e1661 = ((0.5f * (_e1559 - _e1553)) * _e1654);
let _e1662 = ((0.5f * (_e1571 - _e1565)) * _e1654);
let _e1663 = ((0.5f * (_e1583 - _e1577)) * _e1654);
phi_3829_ = type_29(_e1653, vec3<f32>(_e1661, _e1662, _e1663), vec3<f32>((_e1661 * _e1653), (_e1662 * _e1653), (_e1663 * _e1653)));
} else {
let _e1670 = (_e1553 * 1024f);
let _e1672 = select(0f, _e1670, (_e1670 > 0f));
let _e1674 = select(_e1585, _e1672, (_e1672 < _e1585));
let _e1681 = select(0i, select(select(i32(_e1674), i32(-2147483648), (_e1674 < -2147483600f)), 2147483647i, (_e1674 > 2147483500f)), (_e1674 == _e1674));
let _e1685 = (_e1681 - select(0i, 1i, (_e1674 < f32(_e1681))));
let _e1686 = (262147i + _e1685);
let _e1688 = select(_e1603, _e1686, (_e1686 < _e1603));
let _e1694 = global_4.member[bitcast<u32>(select(0i, _e1688, (_e1688 > 0i)))];
let _e1709 = ((_e1638 + (f32(bitcast<i32>((_e1694 >> bitcast<u32>(12u)))) * _e1647)) + ((f32((bitcast<i32>((_e1694 & 4095u)) - 2048i)) * _e1628) * (_e1670 - f32(_e1685))));
let _e1710 = (_e1559 * 1024f);
let _e1712 = select(0f, _e1710, (_e1710 > 0f));
let _e1714 = select(_e1585, _e1712, (_e1712 < _e1585));
let _e1721 = select(0i, select(select(i32(_e1714), i32(-2147483648), (_e1714 < -2147483600f)), 2147483647i, (_e1714 > 2147483500f)), (_e1714 == _e1714));
let _e1725 = (_e1721 - select(0i, 1i, (_e1714 < f32(_e1721))));
let _e1726 = (262147i + _e1725);
let _e1728 = select(_e1603, _e1726, (_e1726 < _e1603));
let _e1734 = global_4.member[bitcast<u32>(select(0i, _e1728, (_e1728 > 0i)))];
let _e1749 = ((_e1638 + (f32(bitcast<i32>((_e1734 >> bitcast<u32>(12u)))) * _e1647)) + ((f32((bitcast<i32>((_e1734 & 4095u)) - 2048i)) * _e1628) * (_e1710 - f32(_e1725))));
let _e1750 = (_e1565 * 1024f);
let _e1752 = select(0f, _e1750, (_e1750 > 0f));
let _e1754 = select(_e1585, _e1752, (_e1752 < _e1585));
let _e1761 = select(0i, select(select(i32(_e1754), i32(-2147483648), (_e1754 < -2147483600f)), 2147483647i, (_e1754 > 2147483500f)), (_e1754 == _e1754));
let _e1765 = (_e1761 - select(0i, 1i, (_e1754 < f32(_e1761))));
let _e1766 = (262147i + _e1765);
let _e1768 = select(_e1603, _e1766, (_e1766 < _e1603));
let _e1774 = global_4.member[bitcast<u32>(select(0i, _e1768, (_e1768 > 0i)))];
let _e1789 = ((_e1638 + (f32(bitcast<i32>((_e1774 >> bitcast<u32>(12u)))) * _e1647)) + ((f32((bitcast<i32>((_e1774 & 4095u)) - 2048i)) * _e1628) * (_e1750 - f32(_e1765))));
let _e1790 = (_e1571 * 1024f);
let _e1792 = select(0f, _e1790, (_e1790 > 0f));
let _e1794 = select(_e1585, _e1792, (_e1792 < _e1585));
let _e1801 = select(0i, select(select(i32(_e1794), i32(-2147483648), (_e1794 < -2147483600f)), 2147483647i, (_e1794 > 2147483500f)), (_e1794 == _e1794));
let _e1805 = (_e1801 - select(0i, 1i, (_e1794 < f32(_e1801))));
let _e1806 = (262147i + _e1805);
let _e1808 = select(_e1603, _e1806, (_e1806 < _e1603));
let _e1814 = global_4.member[bitcast<u32>(select(0i, _e1808, (_e1808 > 0i)))];
let _e1829 = ((_e1638 + (f32(bitcast<i32>((_e1814 >> bitcast<u32>(12u)))) * _e1647)) + ((f32((bitcast<i32>((_e1814 & 4095u)) - 2048i)) * _e1628) * (_e1790 - f32(_e1805))));
let _e1830 = (_e1577 * 1024f);
let _e1832 = select(0f, _e1830, (_e1830 > 0f));
let _e1834 = select(_e1585, _e1832, (_e1832 < _e1585));
let _e1841 = select(0i, select(select(i32(_e1834), i32(-2147483648), (_e1834 < -2147483600f)), 2147483647i, (_e1834 > 2147483500f)), (_e1834 == _e1834));
let _e1845 = (_e1841 - select(0i, 1i, (_e1834 < f32(_e1841))));
let _e1846 = (262147i + _e1845);
let _e1848 = select(_e1603, _e1846, (_e1846 < _e1603));
let _e1854 = global_4.member[bitcast<u32>(select(0i, _e1848, (_e1848 > 0i)))];
let _e1869 = ((_e1638 + (f32(bitcast<i32>((_e1854 >> bitcast<u32>(12u)))) * _e1647)) + ((f32((bitcast<i32>((_e1854 & 4095u)) - 2048i)) * _e1628) * (_e1830 - f32(_e1845))));
let _e1870 = (_e1583 * 1024f);
let _e1872 = select(0f, _e1870, (_e1870 > 0f));
let _e1874 = select(_e1585, _e1872, (_e1872 < _e1585));
let _e1881 = select(0i, select(select(i32(_e1874), i32(-2147483648), (_e1874 < -2147483600f)), 2147483647i, (_e1874 > 2147483500f)), (_e1874 == _e1874));
let _e1885 = (_e1881 - select(0i, 1i, (_e1874 < f32(_e1881))));
let _e1886 = (262147i + _e1885);
let _e1888 = select(_e1603, _e1886, (_e1886 < _e1603));
let _e1894 = global_4.member[bitcast<u32>(select(0i, _e1888, (_e1888 > 0i)))];
let _e1909 = ((_e1638 + (f32(bitcast<i32>((_e1894 >> bitcast<u32>(12u)))) * _e1647)) + ((f32((bitcast<i32>((_e1894 & 4095u)) - 2048i)) * _e1628) * (_e1870 - f32(_e1885))));
let _e1910 = (_e1749 - _e1709);
let _e1912 = (_e1829 - _e1789);
let _e1914 = (_e1909 - _e1869);
phi_3829_ = type_29(_e1653, vec3<f32>((0.5f * _e1910), (0.5f * _e1912), (0.5f * _e1914)), vec3<f32>((0.25f * (_e1910 * (_e1749 + _e1709))), (0.25f * (_e1912 * (_e1829 + _e1789))), (0.25f * (_e1914 * (_e1909 + _e1869)))));
}
let _e1929 = phi_3829_;
let _e1944 = select(0f, 1f, ((((((_e433 >= -0.5f) && (_e433 <= _e455)) && (_e439 >= -0.5f)) && (_e439 <= _e465)) && (_e445 >= -0.5f)) && (_e445 <= _e475)));
let _e1946 = (0.5f * (_e1559 - _e1553));
let _e1948 = (0.5f * (_e1571 - _e1565));
let _e1950 = (0.5f * (_e1583 - _e1577));
let _e1956 = global_1.member.member_6.member.member.member;
let _e1962 = global_1.member.member_6.member.member.member_1;
let _e1968 = global_1.member.member_6.member.member.member_2;
let _e1974 = global_1.member.member_6.member_1.member.member;
let _e1980 = global_1.member.member_6.member_1.member.member_1;
let _e1986 = global_1.member.member_6.member_1.member.member_2;
let _e1992 = global_1.member.member_6.member_2.member.member;
let _e1998 = global_1.member.member_6.member_2.member.member_1;
let _e2004 = global_1.member.member_6.member_2.member.member_2;
phi_4531_ = type_30(_e1547, vec3<f32>(((((_e1956 * _e1946) + (_e1974 * _e1948)) + (_e1992 * _e1950)) * _e1944), ((((_e1962 * _e1946) + (_e1980 * _e1948)) + (_e1998 * _e1950)) * _e1944), ((((_e1968 * _e1946) + (_e1986 * _e1948)) + (_e2004 * _e1950)) * _e1944)), _e1929.member, vec3<f32>(((((_e1956 * _e1929.member_2.x) + (_e1974 * _e1929.member_2.y)) + (_e1992 * _e1929.member_2.z)) * _e1944), ((((_e1962 * _e1929.member_2.x) + (_e1980 * _e1929.member_2.y)) + (_e1998 * _e1929.member_2.z)) * _e1944), ((((_e1968 * _e1929.member_2.x) + (_e1986 * _e1929.member_2.y)) + (_e2004 * _e1929.member_2.z)) * _e1944)), vec3<f32>(((((_e1956 * _e1929.member_1.x) + (_e1974 * _e1929.member_1.y)) + (_e1992 * _e1929.member_1.z)) * _e1944), ((((_e1962 * _e1929.member_1.x) + (_e1980 * _e1929.member_1.y)) + (_e1998 * _e1929.member_1.z)) * _e1944), ((((_e1968 * _e1929.member_1.x) + (_e1986 * _e1929.member_1.y)) + (_e2004 * _e1929.member_1.z)) * _e1944)));
} else {
let _e2070 = select(-1f, _e459, (_e459 > -1f));
let _e2072 = select(_e454, _e2070, (_e2070 < _e454));
let _e2079 = select(0i, select(select(i32(_e2072), i32(-2147483648), (_e2072 < -2147483600f)), 2147483647i, (_e2072 > 2147483500f)), (_e2072 == _e2072));
let _e2083 = (_e2079 - select(0i, 1i, (_e2072 < f32(_e2079))));
let _e2085 = select(-1f, _e469, (_e469 > -1f));
let _e2087 = select(_e464, _e2085, (_e2085 < _e464));
let _e2094 = select(0i, select(select(i32(_e2087), i32(-2147483648), (_e2087 < -2147483600f)), 2147483647i, (_e2087 > 2147483500f)), (_e2087 == _e2087));
let _e2098 = (_e2094 - select(0i, 1i, (_e2087 < f32(_e2094))));
let _e2100 = select(-1f, _e479, (_e479 > -1f));
let _e2102 = select(_e474, _e2100, (_e2100 < _e474));
let _e2109 = select(0i, select(select(i32(_e2102), i32(-2147483648), (_e2102 < -2147483600f)), 2147483647i, (_e2102 > 2147483500f)), (_e2102 == _e2102));
let _e2113 = (_e2109 - select(0i, 1i, (_e2102 < f32(_e2109))));
let _e2117 = global_1.member.member_6.member_7;
let _e2121 = global_1.member.member_6.member_8;
let _e2122 = (_e2083 + 1i);
let _e2123 = (_e2098 + 1i);
let _e2124 = (_e2113 + 1i);
let _e2129 = global_1.member.member_6.member_11.member;
let _e2135 = global_1.member.member_6.member_11.member_1;
let _e2146 = ((_e2122 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2129) * ((_e2123 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2135) * (_e2124 >> bitcast<u32>(4i))))));
let _e2148 = (bitcast<i32>(_e93) - 1i);
let _e2150 = select(_e2148, _e2146, (_e2146 < _e2148));
let _e2156 = global_2.member[bitcast<u32>(select(0i, _e2150, (_e2150 > 0i)))];
let _e2158 = (_e2122 & 15i);
let _e2161 = ((_e2123 & 15i) * _e2117);
let _e2163 = (bitcast<i32>(_e2156) + ((_e2124 & 15i) * _e2121));
let _e2164 = (_e2161 + _e2117);
let _e2166 = (_e2161 + (2i * _e2117));
let _e2167 = (_e2163 + _e2121);
let _e2169 = (_e2163 + (2i * _e2121));
local_2 = type_28(array<i32, 4>(_e2158, _e2158, _e2158, _e2158), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_3 = vec3<f32>((_e459 - f32(_e2083)), (_e469 - f32(_e2098)), (_e479 - f32(_e2113)));
let _e2183 = local_2.member[0u];
let _e2184 = ((_e2167 + _e2164) + _e2183);
let _e2186 = (_e2184 >> bitcast<u32>(2i));
let _e2189 = bitcast<u32>(((_e2184 & 3i) * 8i));
let _e2191 = select(_e2148, _e2186, (_e2186 < _e2148));
let _e2196 = global_2.member[bitcast<u32>(select(0i, _e2191, (_e2191 > 0i)))];
let _e2200 = (_e2186 + 1i);
let _e2202 = select(_e2148, _e2200, (_e2200 < _e2148));
let _e2207 = global_2.member[bitcast<u32>(select(0i, _e2202, (_e2202 > 0i)))];
let _e2214 = ((_e2196 >> bitcast<u32>((_e2189 & 31u))) | ((_e2207 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2189) & 31u))));
let _e2217 = local_2.member_1[1u];
let _e2223 = f32(bitcast<i32>(((_e2214 >> bitcast<u32>((_e2217 & 31u))) & 255u)));
let _e2226 = local_2.member_1[2u];
let _e2233 = local_3[0u];
let _e2236 = (_e2223 + ((f32(bitcast<i32>(((_e2214 >> bitcast<u32>((_e2226 & 31u))) & 255u))) - _e2223) * _e2233));
let _e2238 = local_2.member[0u];
let _e2239 = ((_e2167 + _e2166) + _e2238);
let _e2241 = (_e2239 >> bitcast<u32>(2i));
let _e2244 = bitcast<u32>(((_e2239 & 3i) * 8i));
let _e2246 = select(_e2148, _e2241, (_e2241 < _e2148));
let _e2251 = global_2.member[bitcast<u32>(select(0i, _e2246, (_e2246 > 0i)))];
let _e2255 = (_e2241 + 1i);
let _e2257 = select(_e2148, _e2255, (_e2255 < _e2148));
let _e2262 = global_2.member[bitcast<u32>(select(0i, _e2257, (_e2257 > 0i)))];
let _e2269 = ((_e2251 >> bitcast<u32>((_e2244 & 31u))) | ((_e2262 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2244) & 31u))));
let _e2270 = local_2.member_1[1u];
let _e2276 = f32(bitcast<i32>(((_e2269 >> bitcast<u32>((_e2270 & 31u))) & 255u)));
let _e2277 = local_2.member_1[2u];
let _e2284 = local_3[0u];
let _e2289 = local_3[1u];
let _e2292 = (_e2236 + (((_e2276 + ((f32(bitcast<i32>(((_e2269 >> bitcast<u32>((_e2277 & 31u))) & 255u))) - _e2276) * _e2284)) - _e2236) * _e2289));
let _e2294 = local_2.member[0u];
let _e2295 = ((_e2169 + _e2164) + _e2294);
let _e2297 = (_e2295 >> bitcast<u32>(2i));
let _e2300 = bitcast<u32>(((_e2295 & 3i) * 8i));
let _e2302 = select(_e2148, _e2297, (_e2297 < _e2148));
let _e2307 = global_2.member[bitcast<u32>(select(0i, _e2302, (_e2302 > 0i)))];
let _e2311 = (_e2297 + 1i);
let _e2313 = select(_e2148, _e2311, (_e2311 < _e2148));
let _e2318 = global_2.member[bitcast<u32>(select(0i, _e2313, (_e2313 > 0i)))];
let _e2325 = ((_e2307 >> bitcast<u32>((_e2300 & 31u))) | ((_e2318 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2300) & 31u))));
let _e2326 = local_2.member_1[1u];
let _e2332 = f32(bitcast<i32>(((_e2325 >> bitcast<u32>((_e2326 & 31u))) & 255u)));
let _e2333 = local_2.member_1[2u];
let _e2340 = local_3[0u];
let _e2343 = (_e2332 + ((f32(bitcast<i32>(((_e2325 >> bitcast<u32>((_e2333 & 31u))) & 255u))) - _e2332) * _e2340));
let _e2345 = local_2.member[0u];
let _e2346 = ((_e2169 + _e2166) + _e2345);
let _e2348 = (_e2346 >> bitcast<u32>(2i));
let _e2351 = bitcast<u32>(((_e2346 & 3i) * 8i));
let _e2353 = select(_e2148, _e2348, (_e2348 < _e2148));
let _e2358 = global_2.member[bitcast<u32>(select(0i, _e2353, (_e2353 > 0i)))];
let _e2362 = (_e2348 + 1i);
let _e2364 = select(_e2148, _e2362, (_e2362 < _e2148));
let _e2369 = global_2.member[bitcast<u32>(select(0i, _e2364, (_e2364 > 0i)))];
let _e2376 = ((_e2358 >> bitcast<u32>((_e2351 & 31u))) | ((_e2369 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2351) & 31u))));
let _e2377 = local_2.member_1[1u];
let _e2383 = f32(bitcast<i32>(((_e2376 >> bitcast<u32>((_e2377 & 31u))) & 255u)));
let _e2384 = local_2.member_1[2u];
let _e2391 = local_3[0u];
let _e2395 = local_3[1u];
let _e2400 = local_3[2u];
let _e2407 = global_1.member.member_6.member_5;
let _e2412 = global_1.member.member_6.member_6;
let _e2413 = (((_e2292 + (((_e2343 + (((_e2383 + ((f32(bitcast<i32>(((_e2376 >> bitcast<u32>((_e2384 & 31u))) & 255u))) - _e2383) * _e2391)) - _e2343) * _e2395)) - _e2292) * _e2400)) * _e2407) + _e2412);
let _e2415 = select(0f, _e2413, (_e2413 > 0f));
phi_4531_ = type_30(select(1f, _e2415, (_e2415 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2420 = phi_4531_;
let _e2422 = select(-0.5f, _e397, (_e397 > -0.5f));
let _e2424 = select(_e455, _e2422, (_e2422 < _e455));
let _e2426 = select(-0.5f, _e412, (_e412 > -0.5f));
let _e2428 = select(_e465, _e2426, (_e2426 < _e465));
let _e2430 = select(-0.5f, _e427, (_e427 > -0.5f));
let _e2432 = select(_e475, _e2430, (_e2430 < _e475));
let _e2434 = select(-1f, _e2424, (_e2424 > -1f));
let _e2436 = select(_e454, _e2434, (_e2434 < _e454));
let _e2443 = select(0i, select(select(i32(_e2436), i32(-2147483648), (_e2436 < -2147483600f)), 2147483647i, (_e2436 > 2147483500f)), (_e2436 == _e2436));
let _e2447 = (_e2443 - select(0i, 1i, (_e2436 < f32(_e2443))));
let _e2449 = select(-1f, _e2428, (_e2428 > -1f));
let _e2451 = select(_e464, _e2449, (_e2449 < _e464));
let _e2458 = select(0i, select(select(i32(_e2451), i32(-2147483648), (_e2451 < -2147483600f)), 2147483647i, (_e2451 > 2147483500f)), (_e2451 == _e2451));
let _e2462 = (_e2458 - select(0i, 1i, (_e2451 < f32(_e2458))));
let _e2464 = select(-1f, _e2432, (_e2432 > -1f));
let _e2466 = select(_e474, _e2464, (_e2464 < _e474));
let _e2473 = select(0i, select(select(i32(_e2466), i32(-2147483648), (_e2466 < -2147483600f)), 2147483647i, (_e2466 > 2147483500f)), (_e2466 == _e2466));
let _e2477 = (_e2473 - select(0i, 1i, (_e2466 < f32(_e2473))));
let _e2481 = global_1.member.member_6.member_7;
let _e2485 = global_1.member.member_6.member_8;
let _e2486 = (_e2447 + 1i);
let _e2487 = (_e2462 + 1i);
let _e2488 = (_e2477 + 1i);
let _e2493 = global_1.member.member_6.member_11.member;
let _e2499 = global_1.member.member_6.member_11.member_1;
let _e2510 = ((_e2486 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2493) * ((_e2487 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2499) * (_e2488 >> bitcast<u32>(4i))))));
let _e2512 = (bitcast<i32>(_e93) - 1i);
let _e2514 = select(_e2512, _e2510, (_e2510 < _e2512));
let _e2520 = global_2.member[bitcast<u32>(select(0i, _e2514, (_e2514 > 0i)))];
let _e2522 = (_e2486 & 15i);
let _e2525 = ((_e2487 & 15i) * _e2481);
let _e2527 = (bitcast<i32>(_e2520) + ((_e2488 & 15i) * _e2485));
let _e2528 = (_e2525 + _e2481);
let _e2530 = (_e2525 + (2i * _e2481));
let _e2531 = (_e2527 + _e2485);
let _e2533 = (_e2527 + (2i * _e2485));
local = type_28(array<i32, 4>(_e2522, _e2522, _e2522, _e2522), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_1 = vec3<f32>((_e2424 - f32(_e2447)), (_e2428 - f32(_e2462)), (_e2432 - f32(_e2477)));
let _e2547 = local.member[0u];
let _e2548 = ((_e2531 + _e2528) + _e2547);
let _e2550 = (_e2548 >> bitcast<u32>(2i));
let _e2553 = bitcast<u32>(((_e2548 & 3i) * 8i));
let _e2555 = select(_e2512, _e2550, (_e2550 < _e2512));
let _e2560 = global_2.member[bitcast<u32>(select(0i, _e2555, (_e2555 > 0i)))];
let _e2564 = (_e2550 + 1i);
let _e2566 = select(_e2512, _e2564, (_e2564 < _e2512));
let _e2571 = global_2.member[bitcast<u32>(select(0i, _e2566, (_e2566 > 0i)))];
let _e2578 = ((_e2560 >> bitcast<u32>((_e2553 & 31u))) | ((_e2571 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2553) & 31u))));
let _e2581 = local.member_1[1u];
let _e2587 = f32(bitcast<i32>(((_e2578 >> bitcast<u32>((_e2581 & 31u))) & 255u)));
let _e2590 = local.member_1[2u];
let _e2597 = local_1[0u];
let _e2600 = (_e2587 + ((f32(bitcast<i32>(((_e2578 >> bitcast<u32>((_e2590 & 31u))) & 255u))) - _e2587) * _e2597));
let _e2602 = local.member[0u];
let _e2603 = ((_e2531 + _e2530) + _e2602);
let _e2605 = (_e2603 >> bitcast<u32>(2i));
let _e2608 = bitcast<u32>(((_e2603 & 3i) * 8i));
let _e2610 = select(_e2512, _e2605, (_e2605 < _e2512));
let _e2615 = global_2.member[bitcast<u32>(select(0i, _e2610, (_e2610 > 0i)))];
let _e2619 = (_e2605 + 1i);
let _e2621 = select(_e2512, _e2619, (_e2619 < _e2512));
let _e2626 = global_2.member[bitcast<u32>(select(0i, _e2621, (_e2621 > 0i)))];
let _e2633 = ((_e2615 >> bitcast<u32>((_e2608 & 31u))) | ((_e2626 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2608) & 31u))));
let _e2634 = local.member_1[1u];
let _e2640 = f32(bitcast<i32>(((_e2633 >> bitcast<u32>((_e2634 & 31u))) & 255u)));
let _e2641 = local.member_1[2u];
let _e2648 = local_1[0u];
let _e2653 = local_1[1u];
let _e2656 = (_e2600 + (((_e2640 + ((f32(bitcast<i32>(((_e2633 >> bitcast<u32>((_e2641 & 31u))) & 255u))) - _e2640) * _e2648)) - _e2600) * _e2653));
let _e2658 = local.member[0u];
let _e2659 = ((_e2533 + _e2528) + _e2658);
let _e2661 = (_e2659 >> bitcast<u32>(2i));
let _e2664 = bitcast<u32>(((_e2659 & 3i) * 8i));
let _e2666 = select(_e2512, _e2661, (_e2661 < _e2512));
let _e2671 = global_2.member[bitcast<u32>(select(0i, _e2666, (_e2666 > 0i)))];
let _e2675 = (_e2661 + 1i);
let _e2677 = select(_e2512, _e2675, (_e2675 < _e2512));
let _e2682 = global_2.member[bitcast<u32>(select(0i, _e2677, (_e2677 > 0i)))];
let _e2689 = ((_e2671 >> bitcast<u32>((_e2664 & 31u))) | ((_e2682 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2664) & 31u))));
let _e2690 = local.member_1[1u];
let _e2696 = f32(bitcast<i32>(((_e2689 >> bitcast<u32>((_e2690 & 31u))) & 255u)));
let _e2697 = local.member_1[2u];
let _e2704 = local_1[0u];
let _e2707 = (_e2696 + ((f32(bitcast<i32>(((_e2689 >> bitcast<u32>((_e2697 & 31u))) & 255u))) - _e2696) * _e2704));
let _e2709 = local.member[0u];
let _e2710 = ((_e2533 + _e2530) + _e2709);
let _e2712 = (_e2710 >> bitcast<u32>(2i));
let _e2715 = bitcast<u32>(((_e2710 & 3i) * 8i));
let _e2717 = select(_e2512, _e2712, (_e2712 < _e2512));
let _e2722 = global_2.member[bitcast<u32>(select(0i, _e2717, (_e2717 > 0i)))];
let _e2726 = (_e2712 + 1i);
let _e2728 = select(_e2512, _e2726, (_e2726 < _e2512));
let _e2733 = global_2.member[bitcast<u32>(select(0i, _e2728, (_e2728 > 0i)))];
let _e2740 = ((_e2722 >> bitcast<u32>((_e2715 & 31u))) | ((_e2733 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2715) & 31u))));
let _e2741 = local.member_1[1u];
let _e2747 = f32(bitcast<i32>(((_e2740 >> bitcast<u32>((_e2741 & 31u))) & 255u)));
let _e2748 = local.member_1[2u];
let _e2755 = local_1[0u];
let _e2759 = local_1[1u];
let _e2764 = local_1[2u];
let _e2771 = global_1.member.member_6.member_5;
let _e2776 = global_1.member.member_6.member_6;
let _e2777 = (((_e2656 + (((_e2707 + (((_e2747 + ((f32(bitcast<i32>(((_e2740 >> bitcast<u32>((_e2748 & 31u))) & 255u))) - _e2747) * _e2755)) - _e2707) * _e2759)) - _e2656) * _e2764)) * _e2771) + _e2776);
let _e2779 = select(0f, _e2777, (_e2777 > 0f));
if ((_e613 & 16u) == 0u) {
phi_5456_ = type_5(1f, 1f, 1f);
} else {
let _e2787 = global_1.member.member_14.member;
let _e2798 = ((((_e2787.member.member * _e308) + (_e2787.member.member_1 * _e317)) + (_e2787.member.member_2 * _e290)) + _e2787.member_1);
let _e2804 = ((((_e2787.member.member * _e329) + (_e2787.member.member_1 * _e334)) + (_e2787.member.member_2 * _e323)) + _e2787.member_1);
let _e2806 = select(_e2804, _e2798, (_e2798 < _e2804));
let _e2808 = select(_e2804, _e2798, (_e2798 > _e2804));
let _e2810 = (_e2808 - _e2806);
let _e2813 = (-(_e2806) / select(1e-30f, _e2810, (_e2810 > 1e-30f)));
let _e2815 = select(0f, _e2813, (_e2813 > 0f));
let _e2821 = select(select(select(1f, _e2815, (_e2815 < 1f)), 1f, (_e2808 <= 0f)), 0f, (_e2806 > 0f));
let _e2826 = global_1.member.member_14.member_1;
let _e2827 = (_e2826 != 0u);
let _e2837 = global_1.member.member_15.member;
let _e2848 = ((((_e2837.member.member * _e308) + (_e2837.member.member_1 * _e317)) + (_e2837.member.member_2 * _e290)) + _e2837.member_1);
let _e2854 = ((((_e2837.member.member * _e329) + (_e2837.member.member_1 * _e334)) + (_e2837.member.member_2 * _e323)) + _e2837.member_1);
let _e2856 = select(_e2854, _e2848, (_e2848 < _e2854));
let _e2858 = select(_e2854, _e2848, (_e2848 > _e2854));
let _e2860 = (_e2858 - _e2856);
let _e2863 = (-(_e2856) / select(1e-30f, _e2860, (_e2860 > 1e-30f)));
let _e2865 = select(0f, _e2863, (_e2863 > 0f));
let _e2871 = select(select(select(1f, _e2865, (_e2865 < 1f)), 1f, (_e2858 <= 0f)), 0f, (_e2856 > 0f));
let _e2876 = global_1.member.member_15.member_1;
let _e2877 = (_e2876 != 0u);
let _e2887 = global_1.member.member_16.member;
let _e2898 = ((((_e2887.member.member * _e308) + (_e2887.member.member_1 * _e317)) + (_e2887.member.member_2 * _e290)) + _e2887.member_1);
let _e2904 = ((((_e2887.member.member * _e329) + (_e2887.member.member_1 * _e334)) + (_e2887.member.member_2 * _e323)) + _e2887.member_1);
let _e2906 = select(_e2904, _e2898, (_e2898 < _e2904));
let _e2908 = select(_e2904, _e2898, (_e2898 > _e2904));
let _e2910 = (_e2908 - _e2906);
let _e2913 = (-(_e2906) / select(1e-30f, _e2910, (_e2910 > 1e-30f)));
let _e2915 = select(0f, _e2913, (_e2913 > 0f));
let _e2921 = select(select(select(1f, _e2915, (_e2915 < 1f)), 1f, (_e2908 <= 0f)), 0f, (_e2906 > 0f));
let _e2926 = global_1.member.member_16.member_1;
let _e2927 = (_e2926 != 0u);
let _e2937 = global_1.member.member_17.member;
let _e2948 = ((((_e2937.member.member * _e308) + (_e2937.member.member_1 * _e317)) + (_e2937.member.member_2 * _e290)) + _e2937.member_1);
let _e2954 = ((((_e2937.member.member * _e329) + (_e2937.member.member_1 * _e334)) + (_e2937.member.member_2 * _e323)) + _e2937.member_1);
let _e2956 = select(_e2954, _e2948, (_e2948 < _e2954));
let _e2958 = select(_e2954, _e2948, (_e2948 > _e2954));
let _e2960 = (_e2958 - _e2956);
let _e2963 = (-(_e2956) / select(1e-30f, _e2960, (_e2960 > 1e-30f)));
let _e2965 = select(0f, _e2963, (_e2963 > 0f));
let _e2971 = select(select(select(1f, _e2965, (_e2965 < 1f)), 1f, (_e2958 <= 0f)), 0f, (_e2956 > 0f));
let _e2976 = global_1.member.member_17.member_1;
let _e2977 = (_e2976 != 0u);
phi_5456_ = type_5(((((1f * _e2821) * _e2871) * _e2921) * _e2971), ((((1f * select(1f, _e2821, _e2827)) * select(1f, _e2871, _e2877)) * select(1f, _e2921, _e2927)) * select(1f, _e2971, _e2977)), ((((1f * select(1f, 0f, (_e2827 && (_e2804 > 0f)))) * select(1f, 0f, (_e2877 && (_e2854 > 0f)))) * select(1f, 0f, (_e2927 && (_e2904 > 0f)))) * select(1f, 0f, (_e2977 && (_e2954 > 0f)))));
}
let _e2986 = phi_5456_;
let _e2987 = (_e329 - _e308);
let _e2988 = (_e334 - _e317);
let _e2989 = (_e323 - _e290);
let _e2994 = (((_e2987 * _e2987) + (_e2988 * _e2988)) + (_e2989 * _e2989));
let _e2998 = (_e485 < 1e-12f);
let _e3000 = (1f / select(_e480, 1f, _e2998));
let _e3002 = ((-0.5f - _e397) * _e3000);
let _e3004 = ((_e455 - _e397) * _e3000);
let _e3010 = select(_e3004, _e3002, (_e3002 < _e3004));
let _e3012 = select(0f, _e3010, (_e3010 > 0f));
let _e3015 = select(select(1f, _e3012, (_e3012 < 1f)), select(2f, 0f, ((_e397 >= -0.5f) && (_e397 <= _e455))), _e2998);
let _e3017 = select(_e3004, _e3002, (_e3002 > _e3004));
let _e3019 = select(0f, _e3017, (_e3017 > 0f));
let _e3022 = select(select(1f, _e3019, (_e3019 < 1f)), 1f, _e2998);
let _e3023 = (_e488 < 1e-12f);
let _e3025 = (1f / select(_e481, 1f, _e3023));
let _e3027 = ((-0.5f - _e412) * _e3025);
let _e3029 = ((_e465 - _e412) * _e3025);
let _e3035 = select(_e3029, _e3027, (_e3027 < _e3029));
let _e3037 = select(0f, _e3035, (_e3035 > 0f));
let _e3040 = select(select(1f, _e3037, (_e3037 < 1f)), select(2f, 0f, ((_e412 >= -0.5f) && (_e412 <= _e465))), _e3023);
let _e3042 = select(_e3029, _e3027, (_e3027 > _e3029));
let _e3044 = select(0f, _e3042, (_e3042 > 0f));
let _e3047 = select(select(1f, _e3044, (_e3044 < 1f)), 1f, _e3023);
let _e3048 = (_e493 < 1e-12f);
let _e3050 = (1f / select(_e482, 1f, _e3048));
let _e3052 = ((-0.5f - _e427) * _e3050);
let _e3054 = ((_e475 - _e427) * _e3050);
let _e3060 = select(_e3054, _e3052, (_e3052 < _e3054));
let _e3062 = select(0f, _e3060, (_e3060 > 0f));
let _e3065 = select(select(1f, _e3062, (_e3062 < 1f)), select(2f, 0f, ((_e427 >= -0.5f) && (_e427 <= _e475))), _e3048);
let _e3067 = select(_e3054, _e3052, (_e3052 > _e3054));
let _e3069 = select(0f, _e3067, (_e3067 > 0f));
let _e3072 = select(select(1f, _e3069, (_e3069 < 1f)), 1f, _e3048);
let _e3074 = select(_e3047, _e3022, (_e3022 < _e3047));
let _e3078 = select(_e3040, _e3015, (_e3015 > _e3040));
let _e3081 = (select(_e3072, _e3074, (_e3074 < _e3072)) - select(_e3065, _e3078, (_e3078 > _e3065)));
let _e3088 = global_1.member.member_5.member_3;
let _e3089 = ((sqrt(select(0f, _e2994, (_e2994 > 0f))) * select(0f, _e3081, (_e3081 > 0f))) * _e3088);
let _e3091 = (select(1f, _e2779, (_e2779 < 1f)) * 255f);
let _e3092 = (_e2420.member * 255f);
let _e3093 = (255f - 1f);
let _e3095 = select(0f, _e3091, (_e3091 > 0f));
let _e3097 = select(_e3093, _e3095, (_e3095 < _e3093));
let _e3104 = select(0i, select(select(i32(_e3097), i32(-2147483648), (_e3097 < -2147483600f)), 2147483647i, (_e3097 > 2147483500f)), (_e3097 == _e3097));
let _e3108 = (_e3104 - select(0i, 1i, (_e3097 < f32(_e3104))));
let _e3110 = select(0f, _e3092, (_e3092 > 0f));
let _e3112 = select(_e3093, _e3110, (_e3110 < _e3093));
let _e3119 = select(0i, select(select(i32(_e3112), i32(-2147483648), (_e3112 < -2147483600f)), 2147483647i, (_e3112 > 2147483500f)), (_e3112 == _e3112));
let _e3123 = (_e3119 - select(0i, 1i, (_e3112 < f32(_e3119))));
let _e3126 = (((_e3108 * 256i) + _e3123) * 4i);
let _e3128 = (_e3091 - f32(_e3108));
let _e3130 = (_e3092 - f32(_e3123));
let _e3132 = (bitcast<i32>(_e97) - 1i);
let _e3134 = select(_e3132, _e3126, (_e3126 < _e3132));
let _e3140 = global_4.member[bitcast<u32>(select(0i, _e3134, (_e3134 > 0i)))];
let _e3141 = (_e3126 + 4i);
let _e3143 = select(_e3132, _e3141, (_e3141 < _e3132));
let _e3149 = global_4.member[bitcast<u32>(select(0i, _e3143, (_e3143 > 0i)))];
let _e3150 = (_e3126 + 1024i);
let _e3152 = select(_e3132, _e3150, (_e3150 < _e3132));
let _e3158 = global_4.member[bitcast<u32>(select(0i, _e3152, (_e3152 > 0i)))];
let _e3159 = (_e3126 + 1028i);
let _e3161 = select(_e3132, _e3159, (_e3159 < _e3132));
let _e3167 = global_4.member[bitcast<u32>(select(0i, _e3161, (_e3161 > 0i)))];
let _e3172 = (bitcast<f32>(((_e3140 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3180 = (_e3172 + (((bitcast<f32>(((_e3149 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3172) * _e3130));
let _e3185 = (bitcast<f32>(((_e3158 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3209 = (bitcast<f32>((((_e3140 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3217 = (_e3209 + (((bitcast<f32>((((_e3149 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3209) * _e3130));
let _e3222 = (bitcast<f32>((((_e3158 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3234 = (_e3126 + 1i);
let _e3236 = select(_e3132, _e3234, (_e3234 < _e3132));
let _e3242 = global_4.member[bitcast<u32>(select(0i, _e3236, (_e3236 > 0i)))];
let _e3243 = (_e3126 + 5i);
let _e3245 = select(_e3132, _e3243, (_e3243 < _e3132));
let _e3251 = global_4.member[bitcast<u32>(select(0i, _e3245, (_e3245 > 0i)))];
let _e3252 = (_e3126 + 1025i);
let _e3254 = select(_e3132, _e3252, (_e3252 < _e3132));
let _e3260 = global_4.member[bitcast<u32>(select(0i, _e3254, (_e3254 > 0i)))];
let _e3261 = (_e3126 + 1029i);
let _e3263 = select(_e3132, _e3261, (_e3261 < _e3132));
let _e3269 = global_4.member[bitcast<u32>(select(0i, _e3263, (_e3263 > 0i)))];
let _e3274 = (bitcast<f32>(((_e3242 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3282 = (_e3274 + (((bitcast<f32>(((_e3251 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3274) * _e3130));
let _e3287 = (bitcast<f32>(((_e3260 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3311 = (bitcast<f32>((((_e3242 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3319 = (_e3311 + (((bitcast<f32>((((_e3251 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3311) * _e3130));
let _e3324 = (bitcast<f32>((((_e3260 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3339 = (_e3089 * _e2986.member_1);
let _e3341 = -(((_e3217 + (((_e3222 + (((bitcast<f32>((((_e3167 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3222) * _e3130)) - _e3217) * _e3128)) * _e3339));
let _e3343 = select(-87f, _e3341, (_e3341 > -87f));
let _e3345 = select(88f, _e3343, (_e3343 < 88f));
let _e3347 = ((_e3345 * 1.442695f) + 0.5f);
let _e3349 = select(-127f, _e3347, (_e3347 > -127f));
let _e3351 = select(128f, _e3349, (_e3349 < 128f));
let _e3358 = select(0i, select(select(i32(_e3351), i32(-2147483648), (_e3351 < -2147483600f)), 2147483647i, (_e3351 > 2147483500f)), (_e3351 == _e3351));
let _e3362 = (_e3358 - select(0i, 1i, (_e3351 < f32(_e3358))));
let _e3363 = f32(_e3362);
let _e3367 = ((_e3345 - (_e3363 * 0.6933594f)) - (_e3363 * -2.1219444e-4f));
let _e3389 = -(((_e3282 + (((_e3287 + (((bitcast<f32>(((_e3269 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3287) * _e3130)) - _e3282) * _e3128)) * _e3339));
let _e3391 = select(-87f, _e3389, (_e3389 > -87f));
let _e3393 = select(88f, _e3391, (_e3391 < 88f));
let _e3395 = ((_e3393 * 1.442695f) + 0.5f);
let _e3397 = select(-127f, _e3395, (_e3395 > -127f));
let _e3399 = select(128f, _e3397, (_e3397 < 128f));
let _e3406 = select(0i, select(select(i32(_e3399), i32(-2147483648), (_e3399 < -2147483600f)), 2147483647i, (_e3399 > 2147483500f)), (_e3399 == _e3399));
let _e3410 = (_e3406 - select(0i, 1i, (_e3399 < f32(_e3406))));
let _e3411 = f32(_e3410);
let _e3415 = ((_e3393 - (_e3411 * 0.6933594f)) - (_e3411 * -2.1219444e-4f));
let _e3437 = -(((_e3319 + (((_e3324 + (((bitcast<f32>((((_e3269 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3324) * _e3130)) - _e3319) * _e3128)) * _e3339));
let _e3439 = select(-87f, _e3437, (_e3437 > -87f));
let _e3441 = select(88f, _e3439, (_e3439 < 88f));
let _e3443 = ((_e3441 * 1.442695f) + 0.5f);
let _e3445 = select(-127f, _e3443, (_e3443 > -127f));
let _e3447 = select(128f, _e3445, (_e3445 < 128f));
let _e3454 = select(0i, select(select(i32(_e3447), i32(-2147483648), (_e3447 < -2147483600f)), 2147483647i, (_e3447 > 2147483500f)), (_e3447 == _e3447));
let _e3458 = (_e3454 - select(0i, 1i, (_e3447 < f32(_e3454))));
let _e3459 = f32(_e3458);
let _e3463 = ((_e3441 - (_e3459 * 0.6933594f)) - (_e3459 * -2.1219444e-4f));
let _e3485 = -(((_e3180 + (((_e3185 + (((bitcast<f32>(((_e3167 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3185) * _e3130)) - _e3180) * _e3128)) * (_e3089 * _e2986.member)));
let _e3487 = select(-87f, _e3485, (_e3485 > -87f));
let _e3489 = select(88f, _e3487, (_e3487 < 88f));
let _e3491 = ((_e3489 * 1.442695f) + 0.5f);
let _e3493 = select(-127f, _e3491, (_e3491 > -127f));
let _e3495 = select(128f, _e3493, (_e3493 < 128f));
let _e3502 = select(0i, select(select(i32(_e3495), i32(-2147483648), (_e3495 < -2147483600f)), 2147483647i, (_e3495 > 2147483500f)), (_e3495 == _e3495));
let _e3506 = (_e3502 - select(0i, 1i, (_e3495 < f32(_e3502))));
let _e3507 = f32(_e3506);
let _e3511 = ((_e3489 - (_e3507 * 0.6933594f)) - (_e3507 * -2.1219444e-4f));
let _e3531 = ((1f + (_e3511 * (1f + (_e3511 * (0.5f + (_e3511 * (0.16666667f + (_e3511 * (0.041666668f + (_e3511 * (0.008333334f + (_e3511 * (0.001388889f + (_e3511 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3506 + 127i)) << bitcast<u32>(23i))));
if _e630 {
let _e3546 = global_1.member.member_5.member_4;
let _e3549 = (_e2420.member_3.x * _e2986.member_2);
let _e3551 = (_e2420.member_3.y * _e2986.member_2);
let _e3553 = (_e2420.member_3.z * _e2986.member_2);
let _e3554 = (0.5f * (_e247 / _e198));
let _e3558 = (_e176 + (_e3549 * _e3554));
let _e3559 = (_e187 + (_e3551 * _e3554));
let _e3560 = (_e198 + (_e3553 * _e3554));
let _e3562 = (2f * _e247);
let _e3564 = ((_e3560 * _e3560) + (_e3562 * _e3553));
let _e3568 = (_e3560 + sqrt(select(0f, _e3564, (_e3564 > 0f))));
let _e3572 = (0.5f * (_e3562 / select(1e-6f, _e3568, (_e3568 > 1e-6f))));
let _e3576 = (_e3558 + (_e3549 * _e3572));
let _e3577 = (_e3559 + (_e3551 * _e3572));
let _e3578 = (_e3560 + (_e3553 * _e3572));
let _e3582 = (_e3546 * _e3546);
let _e3584 = (_e3578 * _e3578);
let _e3592 = (((_e3560 <= 0f) || (_e3564 <= 0f)) || ((_e3578 <= 0f) || (_e3584 <= (_e3582 * (((_e3576 * _e3576) + (_e3577 * _e3577)) + _e3584)))));
let _e3606 = (_e176 + ((_e2420.member_4.x * _e2986.member_2) * _e247));
let _e3607 = (_e187 + ((_e2420.member_4.y * _e2986.member_2) * _e247));
let _e3608 = (_e198 + ((_e2420.member_4.z * _e2986.member_2) * _e247));
let _e3610 = (_e3608 * _e3608);
let _e3619 = ((_e613 & 1u) != 0u);
phi_6482_ = vec3<f32>(select(select(select(_e3576, _e3558, _e3592), _e3606, _e3619), _e176, _e620), select(select(select(_e3577, _e3559, _e3592), _e3607, _e3619), _e187, _e620), select(select(select(_e3578, _e3560, _e3592), _e3608, _e3619), _e198, _e620));
phi_6483_ = (select(_e3592, ((_e3608 <= 0f) || (_e3610 <= (_e3582 * (((_e3606 * _e3606) + (_e3607 * _e3607)) + _e3610)))), _e3619) && !(_e620));
} else {
phi_6482_ = vec3<f32>(_e176, _e187, _e198);
phi_6483_ = false;
}
let _e3631 = phi_6482_;
let _e3633 = phi_6483_;
global_6.member[_e122] = (_e133 + _e262);
global_6.member[_e134] = (_e143 + _e269);
global_6.member[_e145] = (_e154 + _e371);
global_6.member[_e156] = (_e165 + _e374);
global_6.member[_e167] = _e3631.x;
global_6.member[_e178] = _e3631.y;
global_6.member[_e189] = _e3631.z;
global_6.member[_e200] = select((_e209 * (((1f + (_e3367 * (1f + (_e3367 * (0.5f + (_e3367 * (0.16666667f + (_e3367 * (0.041666668f + (_e3367 * (0.008333334f + (_e3367 * (0.001388889f + (_e3367 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3362 + 127i)) << bitcast<u32>(23i)))) * _e3531)), _e209, _e620);
global_6.member[_e211] = select((_e220 * (((1f + (_e3415 * (1f + (_e3415 * (0.5f + (_e3415 * (0.16666667f + (_e3415 * (0.041666668f + (_e3415 * (0.008333334f + (_e3415 * (0.001388889f + (_e3415 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3410 + 127i)) << bitcast<u32>(23i)))) * _e3531)), _e220, _e620);
global_6.member[_e222] = select((_e231 * (((1f + (_e3463 * (1f + (_e3463 * (0.5f + (_e3463 * (0.16666667f + (_e3463 * (0.041666668f + (_e3463 * (0.008333334f + (_e3463 * (0.001388889f + (_e3463 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3458 + 127i)) << bitcast<u32>(23i)))) * _e3531)), _e231, _e620);
global_6.member[_e233] = select(_e242, 1f, _e3633);
}
}
}
break;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
