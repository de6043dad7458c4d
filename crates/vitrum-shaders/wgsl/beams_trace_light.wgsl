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
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: vec3<f32>,
member_13: vec3<f32>,
member_14: i32,
member_15: i32,
member_16: i32,
member_17: f32,
}
struct type_18 {
member: u32,
member_1: u32,
}
struct type_19 {
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
struct type_20 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
}
struct type_21 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
}
struct type_22 {
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
struct type_23 {
member: type_2,
member_1: type_18,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_19,
member_12: type_20,
member_13: type_21,
member_14: type_9,
member_15: type_6,
member_16: type_5,
member_17: u32,
member_18: type_22,
}
struct type_24 {
member: type_23,
}
struct type_25 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: vec3<f32>,
member_6: vec3<f32>,
member_7: i32,
member_8: i32,
member_9: i32,
member_10: f32,
member_11: i32,
member_12: i32,
member_13: f32,
member_14: f32,
member_15: f32,
member_16: i32,
member_17: i32,
member_18: i32,
member_19: i32,
member_20: i32,
member_21: i32,
member_22: i32,
member_23: f32,
member_24: f32,
member_25: f32,
member_26: f32,
member_27: f32,
}
struct type_26 {
member: i32,
member_1: i32,
member_2: f32,
member_3: f32,
member_4: f32,
}
struct type_29 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(1)
var<storage> global_1: type_13;
@group(0) @binding(2)
var<storage> global_2: type_13;
@group(0) @binding(3)
var<storage> global_3: type_13;
@group(0) @binding(4)
var<storage, read_write> global_4: type_13;
@group(0) @binding(0)
var<storage> global_5: type_24;
@group(0) @binding(5)
var<storage, read_write> global_6: type_29;
fn function_() {
var phi_1742_: f32;
var phi_2374_: f32;
var phi_2401_: type_25;
var phi_2402_: type_25;
var phi_2422_: type_25;
var phi_2424_: type_25;
var phi_2427_: i32;
var phi_2429_: bool;
var phi_3770_: i32;
var phi_3773_: i32;
var phi_3771_: i32;
var phi_3774_: i32;
var local: i32;
var phi_3894_: i32;
var phi_3897_: i32;
var phi_3895_: i32;
var phi_3898_: i32;
var local_1: i32;
var phi_4579_: f32;
var phi_4293_: f32;
var phi_4583_: type_25;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var phi_6571_: f32;
var phi_6572_: f32;
var phi_6805_: f32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var phi_7609_: type_25;
var phi_7619_: type_25;
var phi_7620_: type_25;
var phi_7640_: type_25;
var phi_7795_: vec3<f32>;
var phi_7921_: vec3<f32>;
var phi_7939_: type_25;
var phi_6936_: f32;
var phi_7940_: type_25;
var phi_8095_: f32;
var phi_8139_: type_25;
var phi_8723_: f32;
var phi_9370_: f32;
var phi_9397_: type_25;
var phi_9398_: type_25;
var phi_9399_: type_25;
var phi_9400_: type_25;
var phi_9401_: type_25;
var phi_4637_: f32;
var phi_4649_: type_25;
var phi_4690_: type_25;
var phi_5274_: f32;
var phi_5921_: f32;
var phi_5948_: type_25;
var phi_5949_: type_25;
var phi_9402_: type_25;
var phi_9403_: type_25;
var phi_9404_: bool;
var phi_9408_: type_25;
var phi_9409_: type_25;
var phi_2655_: f32;
var phi_2968_: i32;
var phi_3579_: i32;
var phi_3729_: type_26;
var phi_3723_: bool;
var phi_3724_: bool;
var phi_3730_: type_26;
var phi_3731_: bool;
var phi_3738_: type_17;
var phi_3739_: type_26;
var phi_3740_: type_17;
var phi_3742_: type_26;
var phi_3743_: type_17;
var phi_3744_: bool;
var phi_3748_: type_26;
var phi_3749_: type_17;
var phi_3750_: bool;
var phi_3754_: type_26;
var phi_3755_: type_17;
var phi_9411_: type_25;
var phi_9412_: bool;
var phi_2425_: type_25;
var phi_2428_: i32;
var phi_2430_: bool;
var local_10: type_25;
var local_11: type_25;
var local_12: type_25;
var local_13: type_25;
var local_14: type_25;
var local_15: type_25;
var local_16: type_25;
var local_17: type_25;
var local_18: type_25;
var local_19: type_25;
var local_20: type_25;
var local_21: type_25;
var local_22: type_25;
var local_23: type_25;
var local_24: type_25;
var local_25: type_25;
var local_26: type_25;
var local_27: type_25;
var local_28: type_25;
var local_29: type_25;
var local_30: type_25;
var local_31: type_25;
var local_32: type_25;
var local_33: type_25;
var local_34: type_25;
var local_35: type_25;
var local_36: type_25;
var local_37: type_25;
var local_38: type_25;
var local_39: type_25;
var local_40: type_25;
var local_41: type_25;
var local_42: type_25;
var local_43: type_25;
var local_44: type_25;
var local_45: type_25;
var local_46: type_25;
var local_47: type_25;
var local_48: type_25;
var local_49: type_25;
var local_50: type_25;
var local_51: f32;
let _e120 = global;
let _e122 = arrayLength((&global_1.member));
let _e124 = arrayLength((&global_2.member));
let _e126 = arrayLength((&global_3.member));
let _e133 = global_5.member.member;
if (_e120.x < _e133.member) {
if (_e120.y < _e133.member_1) {
let _e140 = (_e133.member * _e133.member_1);
let _e142 = ((_e120.y * _e133.member) + _e120.x);
let _e143 = bitcast<i32>(_e142);
let _e145 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e147 = select(_e145, _e143, (_e143 < _e145));
let _e153 = global_4.member[bitcast<u32>(select(0i, _e147, (_e147 > 0i)))];
let _e154 = (_e140 + _e142);
let _e155 = bitcast<i32>(_e154);
let _e157 = select(_e145, _e155, (_e155 < _e145));
let _e163 = global_4.member[bitcast<u32>(select(0i, _e157, (_e157 > 0i)))];
let _e165 = ((2u * _e140) + _e142);
let _e166 = bitcast<i32>(_e165);
let _e168 = select(_e145, _e166, (_e166 < _e145));
let _e174 = global_4.member[bitcast<u32>(select(0i, _e168, (_e168 > 0i)))];
let _e176 = ((3u * _e140) + _e142);
let _e177 = bitcast<i32>(_e176);
let _e179 = select(_e145, _e177, (_e177 < _e145));
let _e185 = global_4.member[bitcast<u32>(select(0i, _e179, (_e179 > 0i)))];
let _e187 = ((4u * _e140) + _e142);
let _e188 = bitcast<i32>(_e187);
let _e190 = select(_e145, _e188, (_e188 < _e145));
let _e196 = global_4.member[bitcast<u32>(select(0i, _e190, (_e190 > 0i)))];
let _e198 = ((5u * _e140) + _e142);
let _e199 = bitcast<i32>(_e198);
let _e201 = select(_e145, _e199, (_e199 < _e145));
let _e207 = global_4.member[bitcast<u32>(select(0i, _e201, (_e201 > 0i)))];
let _e209 = ((6u * _e140) + _e142);
let _e210 = bitcast<i32>(_e209);
let _e212 = select(_e145, _e210, (_e210 < _e145));
let _e218 = global_4.member[bitcast<u32>(select(0i, _e212, (_e212 > 0i)))];
let _e220 = ((7u * _e140) + _e142);
let _e221 = bitcast<i32>(_e220);
let _e223 = select(_e145, _e221, (_e221 < _e145));
let _e229 = global_4.member[bitcast<u32>(select(0i, _e223, (_e223 > 0i)))];
let _e231 = ((8u * _e140) + _e142);
let _e232 = bitcast<i32>(_e231);
let _e234 = select(_e145, _e232, (_e232 < _e145));
let _e240 = global_4.member[bitcast<u32>(select(0i, _e234, (_e234 > 0i)))];
let _e242 = ((9u * _e140) + _e142);
let _e243 = bitcast<i32>(_e242);
let _e245 = select(_e145, _e243, (_e243 < _e145));
let _e251 = global_4.member[bitcast<u32>(select(0i, _e245, (_e245 > 0i)))];
let _e253 = ((10u * _e140) + _e142);
let _e254 = bitcast<i32>(_e253);
let _e256 = select(_e145, _e254, (_e254 < _e145));
let _e262 = global_4.member[bitcast<u32>(select(0i, _e256, (_e256 > 0i)))];
let _e264 = ((11u * _e140) + _e142);
let _e265 = bitcast<i32>(_e264);
let _e267 = select(_e145, _e265, (_e265 < _e145));
let _e273 = global_4.member[bitcast<u32>(select(0i, _e267, (_e267 > 0i)))];
let _e275 = ((12u * _e140) + _e142);
let _e276 = bitcast<i32>(_e275);
let _e278 = select(_e145, _e276, (_e276 < _e145));
let _e284 = global_4.member[bitcast<u32>(select(0i, _e278, (_e278 > 0i)))];
let _e286 = ((13u * _e140) + _e142);
let _e287 = bitcast<i32>(_e286);
let _e289 = select(_e145, _e287, (_e287 < _e145));
let _e295 = global_4.member[bitcast<u32>(select(0i, _e289, (_e289 > 0i)))];
let _e297 = ((14u * _e140) + _e142);
let _e298 = bitcast<i32>(_e297);
let _e300 = select(_e145, _e298, (_e298 < _e145));
let _e306 = global_4.member[bitcast<u32>(select(0i, _e300, (_e300 > 0i)))];
let _e308 = ((15u * _e140) + _e142);
let _e309 = bitcast<i32>(_e308);
let _e311 = select(_e145, _e309, (_e309 < _e145));
let _e317 = global_4.member[bitcast<u32>(select(0i, _e311, (_e311 > 0i)))];
let _e319 = ((16u * _e140) + _e142);
let _e320 = bitcast<i32>(_e319);
let _e322 = select(_e145, _e320, (_e320 < _e145));
let _e328 = global_4.member[bitcast<u32>(select(0i, _e322, (_e322 > 0i)))];
let _e330 = ((17u * _e140) + _e142);
let _e331 = bitcast<i32>(_e330);
let _e333 = select(_e145, _e331, (_e331 < _e145));
let _e339 = global_4.member[bitcast<u32>(select(0i, _e333, (_e333 > 0i)))];
let _e341 = ((18u * _e140) + _e142);
let _e342 = bitcast<i32>(_e341);
let _e344 = select(_e145, _e342, (_e342 < _e145));
let _e350 = global_4.member[bitcast<u32>(select(0i, _e344, (_e344 > 0i)))];
let _e352 = ((19u * _e140) + _e142);
let _e353 = bitcast<i32>(_e352);
let _e355 = select(_e145, _e353, (_e353 < _e145));
let _e361 = global_4.member[bitcast<u32>(select(0i, _e355, (_e355 > 0i)))];
let _e363 = ((20u * _e140) + _e142);
let _e364 = bitcast<i32>(_e363);
let _e366 = select(_e145, _e364, (_e364 < _e145));
let _e372 = global_4.member[bitcast<u32>(select(0i, _e366, (_e366 > 0i)))];
let _e374 = ((21u * _e140) + _e142);
let _e375 = bitcast<i32>(_e374);
let _e377 = select(_e145, _e375, (_e375 < _e145));
let _e383 = global_4.member[bitcast<u32>(select(0i, _e377, (_e377 > 0i)))];
let _e385 = ((22u * _e140) + _e142);
let _e386 = bitcast<i32>(_e385);
let _e388 = select(_e145, _e386, (_e386 < _e145));
let _e394 = global_4.member[bitcast<u32>(select(0i, _e388, (_e388 > 0i)))];
let _e396 = ((23u * _e140) + _e142);
let _e397 = bitcast<i32>(_e396);
let _e399 = select(_e145, _e397, (_e397 < _e145));
let _e405 = global_4.member[bitcast<u32>(select(0i, _e399, (_e399 > 0i)))];
let _e407 = ((24u * _e140) + _e142);
let _e408 = bitcast<i32>(_e407);
let _e410 = select(_e145, _e408, (_e408 < _e145));
let _e416 = global_4.member[bitcast<u32>(select(0i, _e410, (_e410 > 0i)))];
let _e418 = ((25u * _e140) + _e142);
let _e419 = bitcast<i32>(_e418);
let _e421 = select(_e145, _e419, (_e419 < _e145));
let _e427 = global_4.member[bitcast<u32>(select(0i, _e421, (_e421 > 0i)))];
let _e429 = ((26u * _e140) + _e142);
let _e430 = bitcast<i32>(_e429);
let _e432 = select(_e145, _e430, (_e430 < _e145));
let _e438 = global_4.member[bitcast<u32>(select(0i, _e432, (_e432 > 0i)))];
let _e440 = ((27u * _e140) + _e142);
let _e441 = bitcast<i32>(_e440);
let _e443 = select(_e145, _e441, (_e441 < _e145));
let _e449 = global_4.member[bitcast<u32>(select(0i, _e443, (_e443 > 0i)))];
let _e451 = ((28u * _e140) + _e142);
let _e452 = bitcast<i32>(_e451);
let _e454 = select(_e145, _e452, (_e452 < _e145));
let _e460 = global_4.member[bitcast<u32>(select(0i, _e454, (_e454 > 0i)))];
let _e462 = ((29u * _e140) + _e142);
let _e463 = bitcast<i32>(_e462);
let _e465 = select(_e145, _e463, (_e463 < _e145));
let _e471 = global_4.member[bitcast<u32>(select(0i, _e465, (_e465 > 0i)))];
let _e473 = ((30u * _e140) + _e142);
let _e474 = bitcast<i32>(_e473);
let _e476 = select(_e145, _e474, (_e474 < _e145));
let _e482 = global_4.member[bitcast<u32>(select(0i, _e476, (_e476 > 0i)))];
let _e484 = ((31u * _e140) + _e142);
let _e485 = bitcast<i32>(_e484);
let _e487 = select(_e145, _e485, (_e485 < _e145));
let _e493 = global_4.member[bitcast<u32>(select(0i, _e487, (_e487 > 0i)))];
let _e495 = ((32u * _e140) + _e142);
let _e496 = bitcast<i32>(_e495);
let _e498 = select(_e145, _e496, (_e496 < _e145));
let _e504 = global_4.member[bitcast<u32>(select(0i, _e498, (_e498 > 0i)))];
let _e506 = ((33u * _e140) + _e142);
let _e507 = bitcast<i32>(_e506);
let _e509 = select(_e145, _e507, (_e507 < _e145));
let _e515 = global_4.member[bitcast<u32>(select(0i, _e509, (_e509 > 0i)))];
let _e517 = ((34u * _e140) + _e142);
let _e518 = bitcast<i32>(_e517);
let _e520 = select(_e145, _e518, (_e518 < _e145));
let _e526 = global_4.member[bitcast<u32>(select(0i, _e520, (_e520 > 0i)))];
let _e528 = ((35u * _e140) + _e142);
let _e529 = bitcast<i32>(_e528);
let _e531 = select(_e145, _e529, (_e529 < _e145));
let _e537 = global_4.member[bitcast<u32>(select(0i, _e531, (_e531 > 0i)))];
let _e539 = ((36u * _e140) + _e142);
let _e540 = bitcast<i32>(_e539);
let _e542 = select(_e145, _e540, (_e540 < _e145));
let _e548 = global_4.member[bitcast<u32>(select(0i, _e542, (_e542 > 0i)))];
let _e550 = ((37u * _e140) + _e142);
let _e551 = bitcast<i32>(_e550);
let _e553 = select(_e145, _e551, (_e551 < _e145));
let _e559 = global_4.member[bitcast<u32>(select(0i, _e553, (_e553 > 0i)))];
let _e561 = ((38u * _e140) + _e142);
let _e562 = bitcast<i32>(_e561);
let _e564 = select(_e145, _e562, (_e562 < _e145));
let _e570 = global_4.member[bitcast<u32>(select(0i, _e564, (_e564 > 0i)))];
let _e572 = ((39u * _e140) + _e142);
let _e573 = bitcast<i32>(_e572);
let _e575 = select(_e145, _e573, (_e573 < _e145));
let _e581 = global_4.member[bitcast<u32>(select(0i, _e575, (_e575 > 0i)))];
let _e583 = ((40u * _e140) + _e142);
let _e584 = bitcast<i32>(_e583);
let _e586 = select(_e145, _e584, (_e584 < _e145));
let _e592 = global_4.member[bitcast<u32>(select(0i, _e586, (_e586 > 0i)))];
let _e594 = ((41u * _e140) + _e142);
let _e595 = bitcast<i32>(_e594);
let _e597 = select(_e145, _e595, (_e595 < _e145));
let _e603 = global_4.member[bitcast<u32>(select(0i, _e597, (_e597 > 0i)))];
let _e610 = select(0i, select(select(i32(_e548), i32(-2147483648), (_e548 < -2147483600f)), 2147483647i, (_e548 > 2147483500f)), (_e548 == _e548));
let _e615 = global_5.member.member_12.member_4;
let _e621 = select(3u, 0u, ((_e471 == 3f) || ((_e471 == 2f) && (_e610 > bitcast<i32>(_e615)))));
if (_e621 > 0u) {
if (arrayLength((&global_6.member)) >= 3u) {
let _e630 = atomicLoad((&global_6.member[0u]));
if (_e630 == 0u) {
atomicStore((&global_6.member[0u]), ((_e133.member + 7u) / 8u));
atomicStore((&global_6.member[1u]), ((_e133.member_1 + 7u) / 8u));
atomicStore((&global_6.member[2u]), 1u);
}
}
}
if (_e621 > 1u) {
let _e692 = select(0i, select(select(i32(_e493), i32(-2147483648), (_e493 < -2147483600f)), 2147483647i, (_e493 > 2147483500f)), (_e493 == _e493));
let _e699 = select(0i, select(select(i32(_e504), i32(-2147483648), (_e504 < -2147483600f)), 2147483647i, (_e504 > 2147483500f)), (_e504 == _e504));
let _e706 = select(0i, select(select(i32(_e515), i32(-2147483648), (_e515 < -2147483600f)), 2147483647i, (_e515 > 2147483500f)), (_e515 == _e515));
let _e713 = select(0i, select(select(i32(_e526), i32(-2147483648), (_e526 < -2147483600f)), 2147483647i, (_e526 > 2147483500f)), (_e526 == _e526));
let _e720 = select(0i, select(select(i32(_e537), i32(-2147483648), (_e537 < -2147483600f)), 2147483647i, (_e537 > 2147483500f)), (_e537 == _e537));
if (_e471 == 0f) {
let _e728 = global_5.member.member_11.member_2;
let _e735 = global_5.member.member_11.member_3;
let _e742 = global_5.member.member_11.member_5;
let _e748 = global_5.member.member_11.member_7;
let _e750 = (_e742 + ((f32(bitcast<i32>(_e120.x)) + 0.5f) * _e748));
let _e754 = global_5.member.member_11.member_6;
let _e760 = global_5.member.member_11.member_8;
let _e762 = (_e754 + ((f32(bitcast<i32>(_e120.y)) + 0.5f) * _e760));
let _e763 = (_e728.member * _e748);
let _e764 = (_e728.member_1 * _e748);
let _e765 = (_e728.member_2 * _e748);
let _e766 = (_e735.member * _e760);
let _e767 = (_e735.member_1 * _e760);
let _e768 = (_e735.member_2 * _e760);
let _e775 = ((_e728.member * _e750) + (_e735.member * _e762));
let _e776 = ((_e728.member_1 * _e750) + (_e735.member_1 * _e762));
let _e777 = ((_e728.member_2 * _e750) + (_e735.member_2 * _e762));
let _e781 = global_5.member.member_11.member_4;
let _e788 = global_5.member.member_11.member_1;
let _e795 = global_5.member.member_10.member;
let _e796 = (_e795 == 0u);
let _e797 = (_e788.member + _e775);
let _e798 = (_e788.member_1 + _e776);
let _e799 = (_e788.member_2 + _e777);
let _e804 = (((_e797 * _e797) + (_e798 * _e798)) + (_e799 * _e799));
let _e808 = (1f / sqrt(select(0f, _e804, (_e804 > 0f))));
let _e812 = select((_e797 * _e808), _e788.member, _e796);
let _e813 = select((_e798 * _e808), _e788.member_1, _e796);
let _e814 = select((_e799 * _e808), _e788.member_2, _e796);
let _e819 = select(_e781.member, (_e781.member + _e775), _e796);
let _e820 = select(_e781.member_1, (_e781.member_1 + _e776), _e796);
let _e821 = select(_e781.member_2, (_e781.member_2 + _e777), _e796);
let _e835 = (((_e763 * _e812) + (_e764 * _e813)) + (_e765 * _e814));
let _e845 = select(((_e763 - (_e812 * _e835)) * _e808), 0f, _e796);
let _e846 = select(((_e764 - (_e813 * _e835)) * _e808), 0f, _e796);
let _e847 = select(((_e765 - (_e814 * _e835)) * _e808), 0f, _e796);
let _e853 = (((_e766 * _e812) + (_e767 * _e813)) + (_e768 * _e814));
let _e863 = select(((_e766 - (_e812 * _e853)) * _e808), 0f, _e796);
let _e864 = select(((_e767 - (_e813 * _e853)) * _e808), 0f, _e796);
let _e865 = select(((_e768 - (_e814 * _e853)) * _e808), 0f, _e796);
let _e874 = (1f / select(_e812, select(1e-12f, -1e-12f, (_e812 < 0f)), (bitcast<f32>((bitcast<u32>(_e812) & 2147483647u)) < 1e-12f)));
let _e882 = (1f / select(_e813, select(1e-12f, -1e-12f, (_e813 < 0f)), (bitcast<f32>((bitcast<u32>(_e813) & 2147483647u)) < 1e-12f)));
let _e890 = (1f / select(_e814, select(1e-12f, -1e-12f, (_e814 < 0f)), (bitcast<f32>((bitcast<u32>(_e814) & 2147483647u)) < 1e-12f)));
let _e893 = global_5.member.member_8;
let _e899 = global_5.member.member_9;
let _e904 = ((_e893.member - _e819) * _e874);
let _e906 = ((_e899.member - _e819) * _e874);
let _e908 = ((_e893.member_1 - _e820) * _e882);
let _e910 = ((_e899.member_1 - _e820) * _e882);
let _e912 = ((_e893.member_2 - _e821) * _e890);
let _e914 = ((_e899.member_2 - _e821) * _e890);
let _e916 = select(_e906, _e904, (_e904 < _e906));
let _e918 = select(_e910, _e908, (_e908 < _e910));
let _e920 = select(_e918, _e916, (_e916 > _e918));
let _e922 = select(_e914, _e912, (_e912 < _e914));
let _e924 = select(_e922, _e920, (_e920 > _e922));
let _e926 = select(_e906, _e904, (_e904 > _e906));
let _e928 = select(_e910, _e908, (_e908 > _e910));
let _e930 = select(_e928, _e926, (_e926 < _e928));
let _e932 = select(_e914, _e912, (_e912 > _e914));
if (true && _e796) {
phi_1742_ = -(1e30f);
} else {
phi_1742_ = 0f;
}
let _e938 = phi_1742_;
let _e940 = select(_e938, _e924, (_e924 > _e938));
let _e942 = ((select(_e932, _e930, (_e930 < _e932)) <= _e940) || false);
let _e943 = select(_e940, 0f, _e942);
let _e944 = (_e812 * _e943);
let _e945 = (_e813 * _e943);
let _e946 = (_e814 * _e943);
let _e947 = (_e819 + _e944);
let _e948 = (_e820 + _e945);
let _e949 = (_e821 + _e946);
let _e966 = global_5.member.member_14.member.member;
let _e977 = ((((_e966.member.member * _e947) + (_e966.member.member_1 * _e948)) + (_e966.member.member_2 * _e949)) + _e966.member_1);
let _e983 = -((((_e966.member.member * _e812) + (_e966.member.member_1 * _e813)) + (_e966.member.member_2 * _e814)));
let _e985 = (_e983 > 1e-9f);
let _e989 = ((_e977 / select(1e-9f, _e983, _e985)) - 0.015625f);
let _e992 = select(1e30f, select(0f, _e989, (_e989 > 0f)), ((_e977 > 0f) && _e985));
let _e997 = global_5.member.member_14.member_1.member;
let _e1008 = ((((_e997.member.member * _e947) + (_e997.member.member_1 * _e948)) + (_e997.member.member_2 * _e949)) + _e997.member_1);
let _e1014 = -((((_e997.member.member * _e812) + (_e997.member.member_1 * _e813)) + (_e997.member.member_2 * _e814)));
let _e1016 = (_e1014 > 1e-9f);
let _e1020 = ((_e1008 / select(1e-9f, _e1014, _e1016)) - 0.015625f);
let _e1023 = select(1e30f, select(0f, _e1020, (_e1020 > 0f)), ((_e1008 > 0f) && _e1016));
let _e1027 = (_e1023 < _e992);
let _e1031 = type_25((vec3<f32>(_e819, _e820, _e821) + vec3<f32>(_e944, _e945, _e946)), vec3<f32>(_e812, _e813, _e814), (vec3<f32>(select(0f, _e763, _e796), select(0f, _e764, _e796), select(0f, _e765, _e796)) + vec3<f32>((_e845 * _e943), (_e846 * _e943), (_e847 * _e943))), (vec3<f32>(select(0f, _e766, _e796), select(0f, _e767, _e796), select(0f, _e768, _e796)) + vec3<f32>((_e863 * _e943), (_e864 * _e943), (_e865 * _e943))), vec3<f32>(_e845, _e846, _e847), vec3<f32>(_e863, _e864, _e865), vec3<f32>(1f, 1f, 1f), 0i, 0i, select(select(-2i, -3i, _e1027), -1i, ((_e992 >= 1e30f) && (_e1023 >= 1e30f))), select(_e992, _e1023, _e1027), 0i, 0i, 0f, _e460, 1f, 0i, _e692, _e699, _e706, _e713, _e720, _e610, _e559, _e570, _e581, _e592, _e603);
let _e1035 = global_5.member.member_13.member_4;
let _e1042 = global_5.member.member_13.member_5;
let _e1047 = ((_e1035.member - _e819) * _e874);
let _e1049 = ((_e1042.member - _e819) * _e874);
let _e1051 = ((_e1035.member_1 - _e820) * _e882);
let _e1053 = ((_e1042.member_1 - _e820) * _e882);
let _e1055 = ((_e1035.member_2 - _e821) * _e890);
let _e1057 = ((_e1042.member_2 - _e821) * _e890);
let _e1059 = select(_e1049, _e1047, (_e1047 < _e1049));
let _e1061 = select(_e1053, _e1051, (_e1051 < _e1053));
let _e1063 = select(_e1061, _e1059, (_e1059 > _e1061));
let _e1065 = select(_e1057, _e1055, (_e1055 < _e1057));
let _e1067 = select(_e1065, _e1063, (_e1063 > _e1065));
let _e1069 = select(_e1049, _e1047, (_e1047 > _e1049));
let _e1071 = select(_e1053, _e1051, (_e1051 > _e1053));
let _e1073 = select(_e1071, _e1069, (_e1069 < _e1071));
let _e1075 = select(_e1057, _e1055, (_e1055 > _e1057));
let _e1077 = select(_e1075, _e1073, (_e1073 < _e1075));
let _e1079 = select(_e938, _e1067, (_e1067 > _e938));
let _e1081 = select(_e943, _e1077, (_e1077 < _e943));
let _e1084 = (select(_e1079, _e1081, (_e1081 > _e1079)) - _e1079);
let _e1088 = global_5.member.member_13.member;
let _e1093 = -((_e1088.member * _e1084));
let _e1095 = select(-87f, _e1093, (_e1093 > -87f));
let _e1097 = select(88f, _e1095, (_e1095 < 88f));
let _e1099 = ((_e1097 * 1.442695f) + 0.5f);
let _e1101 = select(-127f, _e1099, (_e1099 > -127f));
let _e1103 = select(128f, _e1101, (_e1101 < 128f));
let _e1110 = select(0i, select(select(i32(_e1103), i32(-2147483648), (_e1103 < -2147483600f)), 2147483647i, (_e1103 > 2147483500f)), (_e1103 == _e1103));
let _e1114 = (_e1110 - select(0i, 1i, (_e1103 < f32(_e1110))));
let _e1115 = f32(_e1114);
let _e1119 = ((_e1097 - (_e1115 * 0.6933594f)) - (_e1115 * -2.1219444e-4f));
let _e1141 = -((_e1088.member_1 * _e1084));
let _e1143 = select(-87f, _e1141, (_e1141 > -87f));
let _e1145 = select(88f, _e1143, (_e1143 < 88f));
let _e1147 = ((_e1145 * 1.442695f) + 0.5f);
let _e1149 = select(-127f, _e1147, (_e1147 > -127f));
let _e1151 = select(128f, _e1149, (_e1149 < 128f));
let _e1158 = select(0i, select(select(i32(_e1151), i32(-2147483648), (_e1151 < -2147483600f)), 2147483647i, (_e1151 > 2147483500f)), (_e1151 == _e1151));
let _e1162 = (_e1158 - select(0i, 1i, (_e1151 < f32(_e1158))));
let _e1163 = f32(_e1162);
let _e1167 = ((_e1145 - (_e1163 * 0.6933594f)) - (_e1163 * -2.1219444e-4f));
let _e1189 = -((_e1088.member_2 * _e1084));
let _e1191 = select(-87f, _e1189, (_e1189 > -87f));
let _e1193 = select(88f, _e1191, (_e1191 < 88f));
let _e1195 = ((_e1193 * 1.442695f) + 0.5f);
let _e1197 = select(-127f, _e1195, (_e1195 > -127f));
let _e1199 = select(128f, _e1197, (_e1197 < 128f));
let _e1206 = select(0i, select(select(i32(_e1199), i32(-2147483648), (_e1199 < -2147483600f)), 2147483647i, (_e1199 > 2147483500f)), (_e1199 == _e1199));
let _e1210 = (_e1206 - select(0i, 1i, (_e1199 < f32(_e1206))));
let _e1211 = f32(_e1210);
let _e1215 = ((_e1193 - (_e1211 * 0.6933594f)) - (_e1211 * -2.1219444e-4f));
let _e1238 = (1f / 3f);
let _e1240 = (1f * ((1f + (_e1119 * (1f + (_e1119 * (0.5f + (_e1119 * (0.16666667f + (_e1119 * (0.041666668f + (_e1119 * (0.008333334f + (_e1119 * (0.001388889f + (_e1119 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1114 + 127i)) << bitcast<u32>(23i)))));
let _e1241 = (1f * ((1f + (_e1167 * (1f + (_e1167 * (0.5f + (_e1167 * (0.16666667f + (_e1167 * (0.041666668f + (_e1167 * (0.008333334f + (_e1167 * (0.001388889f + (_e1167 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1162 + 127i)) << bitcast<u32>(23i)))));
let _e1242 = (1f * ((1f + (_e1215 * (1f + (_e1215 * (0.5f + (_e1215 * (0.16666667f + (_e1215 * (0.041666668f + (_e1215 * (0.008333334f + (_e1215 * (0.001388889f + (_e1215 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1210 + 127i)) << bitcast<u32>(23i)))));
let _e1271 = type_25(_e1031.member, _e1031.member_1, _e1031.member_2, _e1031.member_3, _e1031.member_4, _e1031.member_5, vec3<f32>(_e1240, _e1241, _e1242), _e1031.member_7, _e1031.member_8, _e1031.member_9, _e1031.member_10, _e1031.member_11, _e1031.member_12, _e1031.member_13, _e1031.member_14, _e1031.member_15, _e1031.member_16, _e1031.member_17, _e1031.member_18, _e1031.member_19, _e1031.member_20, _e1031.member_21, _e1031.member_22, _e1031.member_23, _e1031.member_24, _e1031.member_25, _e1031.member_26, _e1031.member_27);
if (bitcast<i32>(countOneBits(0u)) == _e713) {
phi_2374_ = ((((1f + 1f) + 1f) * _e1238) - (((_e1240 + _e1241) + _e1242) * _e1238));
} else {
phi_2374_ = 0f;
}
let _e1280 = phi_2374_;
let _e1309 = type_25(_e1271.member, _e1271.member_1, _e1271.member_2, _e1271.member_3, _e1271.member_4, _e1271.member_5, _e1271.member_6, _e1271.member_7, _e1271.member_8, _e1271.member_9, _e1271.member_10, _e1271.member_11, _e1271.member_12, _e1271.member_13, _e1271.member_14, _e1271.member_15, _e1271.member_16, _e1271.member_17, _e1271.member_18, _e1271.member_19, _e1271.member_20, _e1271.member_21, _e1271.member_22, _e1271.member_23, _e1271.member_24, _e1271.member_25, (_e592 + _e1280), _e1271.member_27);
if _e942 {
let _e1339 = type_25(_e1309.member, _e1309.member_1, _e1309.member_2, _e1309.member_3, _e1309.member_4, _e1309.member_5, _e1309.member_6, _e1309.member_7, (bitcast<i32>(_e122) / 8i), _e1309.member_9, _e1309.member_10, _e1309.member_11, _e1309.member_12, _e1309.member_13, _e1309.member_14, _e1309.member_15, _e1309.member_16, _e1309.member_17, _e1309.member_18, _e1309.member_19, _e1309.member_20, _e1309.member_21, _e1309.member_22, _e1309.member_23, _e1309.member_24, _e1309.member_25, _e1309.member_26, _e1309.member_27);
phi_2401_ = type_25(_e1339.member, _e1339.member_1, _e1339.member_2, _e1339.member_3, _e1339.member_4, _e1339.member_5, _e1339.member_6, _e1339.member_7, _e1339.member_8, _e1339.member_9, _e1339.member_10, _e1339.member_11, _e1339.member_12, _e1339.member_13, _e1339.member_14, 3f, _e1339.member_16, _e1339.member_17, _e1339.member_18, _e1339.member_19, _e1339.member_20, _e1339.member_21, _e1339.member_22, _e1339.member_23, _e1339.member_24, _e1339.member_25, _e1339.member_26, _e1339.member_27);
} else {
phi_2401_ = _e1309;
}
let _e1369 = phi_2401_;
phi_2402_ = _e1369;
} else {
phi_2402_ = type_25(vec3<f32>(_e153, _e163, _e174), vec3<f32>(_e185, _e196, _e207), vec3<f32>(_e218, _e229, _e240), vec3<f32>(_e251, _e262, _e273), vec3<f32>(_e284, _e295, _e306), vec3<f32>(_e317, _e328, _e339), vec3<f32>(_e350, _e361, _e372), select(0i, select(select(i32(_e383), i32(-2147483648), (_e383 < -2147483600f)), 2147483647i, (_e383 > 2147483500f)), (_e383 == _e383)), select(0i, select(select(i32(_e394), i32(-2147483648), (_e394 < -2147483600f)), 2147483647i, (_e394 > 2147483500f)), (_e394 == _e394)), select(0i, select(select(i32(_e405), i32(-2147483648), (_e405 < -2147483600f)), 2147483647i, (_e405 > 2147483500f)), (_e405 == _e405)), _e416, select(0i, select(select(i32(_e427), i32(-2147483648), (_e427 < -2147483600f)), 2147483647i, (_e427 > 2147483500f)), (_e427 == _e427)), select(0i, select(select(i32(_e438), i32(-2147483648), (_e438 < -2147483600f)), 2147483647i, (_e438 > 2147483500f)), (_e438 == _e438)), _e449, _e460, _e471, select(0i, select(select(i32(_e482), i32(-2147483648), (_e482 < -2147483600f)), 2147483647i, (_e482 > 2147483500f)), (_e482 == _e482)), _e692, _e699, _e706, _e713, _e720, _e610, _e559, _e570, _e581, _e592, _e603);
}
let _e1371 = phi_2402_;
let _e1372 = bitcast<i32>(_e122);
let _e1373 = (_e1372 / 8i);
let _e1375 = (_e1371.member_15 == 2f);
if _e1375 {
phi_2422_ = type_25(_e1371.member, _e1371.member_1, _e1371.member_2, _e1371.member_3, _e1371.member_4, _e1371.member_5, _e1371.member_6, _e1371.member_7, _e1371.member_8, _e1371.member_9, _e1371.member_10, _e1371.member_11, _e1371.member_12, _e1371.member_13, _e1371.member_14, 1f, _e1371.member_16, _e1371.member_17, _e1371.member_18, _e1371.member_19, _e1371.member_20, _e1371.member_21, _e1371.member_22, _e1371.member_23, _e1371.member_24, _e1371.member_25, _e1371.member_26, _e1371.member_27);
} else {
phi_2422_ = _e1371;
}
let _e1405 = phi_2422_;
phi_2424_ = _e1405;
phi_2427_ = 0i;
phi_2429_ = _e1375;
loop {
let _e1407 = phi_2424_;
let _e1409 = phi_2427_;
let _e1411 = phi_2429_;
local_10 = _e1407;
local_11 = _e1407;
local_12 = _e1407;
local_13 = _e1407;
local_14 = _e1407;
local_15 = _e1407;
local_16 = _e1407;
local_17 = _e1407;
local_18 = _e1407;
local_19 = _e1407;
local_20 = _e1407;
local_21 = _e1407;
local_22 = _e1407;
local_23 = _e1407;
local_24 = _e1407;
local_25 = _e1407;
local_26 = _e1407;
local_27 = _e1407;
local_28 = _e1407;
local_29 = _e1407;
local_30 = _e1407;
local_31 = _e1407;
local_32 = _e1407;
local_33 = _e1407;
local_34 = _e1407;
local_35 = _e1407;
local_36 = _e1407;
local_37 = _e1407;
local_38 = _e1407;
local_39 = _e1407;
local_40 = _e1407;
local_41 = _e1407;
local_42 = _e1407;
local_43 = _e1407;
local_44 = _e1407;
local_45 = _e1407;
local_46 = _e1407;
local_47 = _e1407;
local_48 = _e1407;
local_49 = _e1407;
local_50 = _e1407;
let _e1415 = ((_e1409 < 1024i) && (_e1407.member_15 == 1f));
local_51 = _e1407.member_15;
if _e1415 {
if (_e1407.member_8 < _e1373) {
let _e7267 = f32(_e1407.member_11);
let _e7269 = f32(_e1407.member_12);
let _e7271 = vec3<f32>(_e7267, _e7269, _e1407.member_13);
let _e7273 = (_e1407.member_9 >= 0i);
if _e7273 {
let _e7274 = (_e1407.member_9 * 19i);
let _e7276 = (bitcast<i32>(_e124) - 1i);
let _e7278 = select(_e7276, _e7274, (_e7274 < _e7276));
let _e7284 = global_2.member[bitcast<u32>(select(0i, _e7278, (_e7278 > 0i)))];
let _e7285 = (_e7274 + 1i);
let _e7287 = select(_e7276, _e7285, (_e7285 < _e7276));
let _e7293 = global_2.member[bitcast<u32>(select(0i, _e7287, (_e7287 > 0i)))];
let _e7294 = (_e7274 + 2i);
let _e7296 = select(_e7276, _e7294, (_e7294 < _e7276));
let _e7302 = global_2.member[bitcast<u32>(select(0i, _e7296, (_e7296 > 0i)))];
let _e7303 = (_e7274 + 3i);
let _e7305 = select(_e7276, _e7303, (_e7303 < _e7276));
let _e7311 = global_2.member[bitcast<u32>(select(0i, _e7305, (_e7305 > 0i)))];
let _e7312 = (_e7274 + 4i);
let _e7314 = select(_e7276, _e7312, (_e7312 < _e7276));
let _e7320 = global_2.member[bitcast<u32>(select(0i, _e7314, (_e7314 > 0i)))];
let _e7321 = (_e7274 + 5i);
let _e7323 = select(_e7276, _e7321, (_e7321 < _e7276));
let _e7329 = global_2.member[bitcast<u32>(select(0i, _e7323, (_e7323 > 0i)))];
let _e7330 = (_e7311 - _e7284);
let _e7331 = (_e7320 - _e7293);
let _e7332 = (_e7329 - _e7302);
let _e7333 = (_e7274 + 6i);
let _e7335 = select(_e7276, _e7333, (_e7333 < _e7276));
let _e7341 = global_2.member[bitcast<u32>(select(0i, _e7335, (_e7335 > 0i)))];
let _e7342 = (_e7274 + 7i);
let _e7344 = select(_e7276, _e7342, (_e7342 < _e7276));
let _e7350 = global_2.member[bitcast<u32>(select(0i, _e7344, (_e7344 > 0i)))];
let _e7351 = (_e7274 + 8i);
let _e7353 = select(_e7276, _e7351, (_e7351 < _e7276));
let _e7359 = global_2.member[bitcast<u32>(select(0i, _e7353, (_e7353 > 0i)))];
let _e7360 = (_e7341 - _e7284);
let _e7361 = (_e7350 - _e7293);
let _e7362 = (_e7359 - _e7302);
let _e7365 = ((_e7331 * _e7362) - (_e7332 * _e7361));
let _e7368 = ((_e7332 * _e7360) - (_e7330 * _e7362));
let _e7371 = ((_e7330 * _e7361) - (_e7331 * _e7360));
let _e7376 = (((_e7365 * _e7365) + (_e7368 * _e7368)) + (_e7371 * _e7371));
let _e7379 = sqrt(select(0f, _e7376, (_e7376 > 0f)));
let _e7382 = (1f / select(1e-20f, _e7379, (_e7379 > 1e-20f)));
phi_2655_ = (((_e1407.member_1.x * (_e7365 * _e7382)) + (_e1407.member_1.y * (_e7368 * _e7382))) + (_e1407.member_1.z * (_e7371 * _e7382)));
} else {
phi_2655_ = 1f;
}
let _e7395 = phi_2655_;
let _e7402 = select(0i, select(select(i32(_e7267), i32(-2147483648), (_e7267 < -2147483600f)), 2147483647i, (_e7267 > 2147483500f)), (_e7267 == _e7267));
let _e7409 = select(0i, select(select(i32(_e7269), i32(-2147483648), (_e7269 < -2147483600f)), 2147483647i, (_e7269 > 2147483500f)), (_e7269 == _e7269));
let _e7412 = bitcast<f32>((bitcast<u32>(_e7395) & 2147483647u));
let _e7414 = select(1e-3f, _e7412, (_e7412 > 1e-3f));
let _e7415 = type_26(_e7402, _e7409, _e1407.member_13, _e1407.member_14, _e7414);
let _e7420 = global_5.member.member_12.member;
let _e7423 = (_e1407.member_10 + select(0f, (_e7420 / _e7414), _e7273));
let _e7427 = (_e1407.member_8 * 8i);
let _e7430 = bitcast<f32>((bitcast<u32>(_e1407.member_1.x) & 2147483647u));
let _e7435 = (1f / select(_e1407.member_1.x, select(1e-12f, -1e-12f, (_e1407.member_1.x < 0f)), (_e7430 < 1e-12f)));
let _e7438 = bitcast<f32>((bitcast<u32>(_e1407.member_1.y) & 2147483647u));
let _e7443 = (1f / select(_e1407.member_1.y, select(1e-12f, -1e-12f, (_e1407.member_1.y < 0f)), (_e7438 < 1e-12f)));
let _e7446 = bitcast<f32>((bitcast<u32>(_e1407.member_1.z) & 2147483647u));
let _e7451 = (1f / select(_e1407.member_1.z, select(1e-12f, -1e-12f, (_e1407.member_1.z < 0f)), (_e7446 < 1e-12f)));
let _e7452 = (_e1372 - 1i);
let _e7454 = select(_e7452, _e7427, (_e7427 < _e7452));
let _e7460 = global_1.member[bitcast<u32>(select(0i, _e7454, (_e7454 > 0i)))];
let _e7461 = (_e7427 + 1i);
let _e7463 = select(_e7452, _e7461, (_e7461 < _e7452));
let _e7469 = global_1.member[bitcast<u32>(select(0i, _e7463, (_e7463 > 0i)))];
let _e7470 = (_e7427 + 2i);
let _e7472 = select(_e7452, _e7470, (_e7470 < _e7452));
let _e7478 = global_1.member[bitcast<u32>(select(0i, _e7472, (_e7472 > 0i)))];
let _e7479 = (_e7427 + 3i);
let _e7481 = select(_e7452, _e7479, (_e7479 < _e7452));
let _e7487 = global_1.member[bitcast<u32>(select(0i, _e7481, (_e7481 > 0i)))];
let _e7488 = (_e7427 + 4i);
let _e7490 = select(_e7452, _e7488, (_e7488 < _e7452));
let _e7496 = global_1.member[bitcast<u32>(select(0i, _e7490, (_e7490 > 0i)))];
let _e7497 = (_e7427 + 5i);
let _e7499 = select(_e7452, _e7497, (_e7497 < _e7452));
let _e7505 = global_1.member[bitcast<u32>(select(0i, _e7499, (_e7499 > 0i)))];
let _e7508 = ((_e7460 - _e1407.member.x) * _e7435);
let _e7510 = ((_e7487 - _e1407.member.x) * _e7435);
let _e7513 = ((_e7469 - _e1407.member.y) * _e7443);
let _e7515 = ((_e7496 - _e1407.member.y) * _e7443);
let _e7518 = ((_e7478 - _e1407.member.z) * _e7451);
let _e7520 = ((_e7505 - _e1407.member.z) * _e7451);
let _e7522 = select(_e7510, _e7508, (_e7508 < _e7510));
let _e7524 = select(_e7515, _e7513, (_e7513 < _e7515));
let _e7526 = select(_e7524, _e7522, (_e7522 > _e7524));
let _e7528 = select(_e7520, _e7518, (_e7518 < _e7520));
let _e7532 = select(_e7510, _e7508, (_e7508 > _e7510));
let _e7534 = select(_e7515, _e7513, (_e7513 > _e7515));
let _e7536 = select(_e7534, _e7532, (_e7532 < _e7534));
let _e7538 = select(_e7520, _e7518, (_e7518 > _e7520));
let _e7540 = select(_e7538, _e7536, (_e7536 < _e7538));
let _e7545 = ((select(_e7528, _e7526, (_e7526 > _e7528)) <= select(_e7423, _e7540, (_e7540 < _e7423))) && (_e7540 >= _e1407.member_13));
let _e7546 = (_e7427 + 6i);
let _e7548 = select(_e7452, _e7546, (_e7546 < _e7452));
let _e7554 = global_1.member[bitcast<u32>(select(0i, _e7548, (_e7548 > 0i)))];
if _e7545 {
phi_2968_ = (_e1407.member_8 + 1i);
} else {
let _e7562 = (_e7427 + 7i);
let _e7564 = select(_e7452, _e7562, (_e7562 < _e7452));
let _e7570 = global_1.member[bitcast<u32>(select(0i, _e7564, (_e7564 > 0i)))];
phi_2968_ = select(0i, select(select(i32(_e7570), i32(-2147483648), (_e7570 < -2147483600f)), 2147483647i, (_e7570 > 2147483500f)), (_e7570 == _e7570));
}
let _e7580 = phi_2968_;
let _e7581 = type_17(_e1407.member, _e1407.member_1, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), _e7271, _e1407.member_14, 0f, 16i, 0f, 0f, 0f, 0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 0i, _e7580, _e1407.member_9, _e1407.member_10);
let _e7582 = select(-1i, select(0i, select(select(i32(_e7554), i32(-2147483648), (_e7554 < -2147483600f)), 2147483647i, (_e7554 > 2147483500f)), (_e7554 == _e7554)), _e7545);
if (_e7582 < 0i) {
phi_3748_ = type_26();
phi_3749_ = type_17();
phi_3750_ = true;
} else {
let _e7586 = ((_e7430 >= _e7438) && (_e7430 >= _e7446));
let _e7589 = (!(_e7586) && (_e7438 >= _e7446));
let _e7596 = (1f / select(select(_e1407.member_1.z, _e1407.member_1.y, _e7589), _e1407.member_1.x, _e7586));
let _e7597 = (select(select(_e1407.member_1.x, _e1407.member_1.z, _e7589), _e1407.member_1.y, _e7586) * _e7596);
let _e7598 = (select(select(_e1407.member_1.y, _e1407.member_1.x, _e7589), _e1407.member_1.z, _e7586) * _e7596);
let _e7599 = (_e7582 * 19i);
let _e7601 = (bitcast<i32>(_e124) - 1i);
let _e7603 = select(_e7601, _e7599, (_e7599 < _e7601));
let _e7609 = global_2.member[bitcast<u32>(select(0i, _e7603, (_e7603 > 0i)))];
let _e7610 = (_e7599 + 1i);
let _e7612 = select(_e7601, _e7610, (_e7610 < _e7601));
let _e7618 = global_2.member[bitcast<u32>(select(0i, _e7612, (_e7612 > 0i)))];
let _e7619 = (_e7599 + 2i);
let _e7621 = select(_e7601, _e7619, (_e7619 < _e7601));
let _e7627 = global_2.member[bitcast<u32>(select(0i, _e7621, (_e7621 > 0i)))];
let _e7628 = (_e7609 - _e1407.member.x);
let _e7629 = (_e7618 - _e1407.member.y);
let _e7630 = (_e7627 - _e1407.member.z);
let _e7636 = select(select(_e7630, _e7629, _e7589), _e7628, _e7586);
let _e7638 = (select(select(_e7628, _e7630, _e7589), _e7629, _e7586) - (_e7597 * _e7636));
let _e7640 = (select(select(_e7629, _e7628, _e7589), _e7630, _e7586) - (_e7598 * _e7636));
let _e7642 = (_e7599 + 3i);
let _e7644 = select(_e7601, _e7642, (_e7642 < _e7601));
let _e7650 = global_2.member[bitcast<u32>(select(0i, _e7644, (_e7644 > 0i)))];
let _e7651 = (_e7599 + 4i);
let _e7653 = select(_e7601, _e7651, (_e7651 < _e7601));
let _e7659 = global_2.member[bitcast<u32>(select(0i, _e7653, (_e7653 > 0i)))];
let _e7660 = (_e7599 + 5i);
let _e7662 = select(_e7601, _e7660, (_e7660 < _e7601));
let _e7668 = global_2.member[bitcast<u32>(select(0i, _e7662, (_e7662 > 0i)))];
let _e7669 = (_e7650 - _e1407.member.x);
let _e7670 = (_e7659 - _e1407.member.y);
let _e7671 = (_e7668 - _e1407.member.z);
let _e7677 = select(select(_e7671, _e7670, _e7589), _e7669, _e7586);
let _e7679 = (select(select(_e7669, _e7671, _e7589), _e7670, _e7586) - (_e7597 * _e7677));
let _e7681 = (select(select(_e7670, _e7669, _e7589), _e7671, _e7586) - (_e7598 * _e7677));
let _e7683 = (_e7599 + 6i);
let _e7685 = select(_e7601, _e7683, (_e7683 < _e7601));
let _e7691 = global_2.member[bitcast<u32>(select(0i, _e7685, (_e7685 > 0i)))];
let _e7692 = (_e7599 + 7i);
let _e7694 = select(_e7601, _e7692, (_e7692 < _e7601));
let _e7700 = global_2.member[bitcast<u32>(select(0i, _e7694, (_e7694 > 0i)))];
let _e7701 = (_e7599 + 8i);
let _e7703 = select(_e7601, _e7701, (_e7701 < _e7601));
let _e7709 = global_2.member[bitcast<u32>(select(0i, _e7703, (_e7703 > 0i)))];
let _e7710 = (_e7691 - _e1407.member.x);
let _e7711 = (_e7700 - _e1407.member.y);
let _e7712 = (_e7709 - _e1407.member.z);
let _e7718 = select(select(_e7712, _e7711, _e7589), _e7710, _e7586);
let _e7720 = (select(select(_e7710, _e7712, _e7589), _e7711, _e7586) - (_e7597 * _e7718));
let _e7722 = (select(select(_e7711, _e7710, _e7589), _e7712, _e7586) - (_e7598 * _e7718));
let _e7726 = ((_e7720 * _e7681) - (_e7722 * _e7679));
let _e7729 = ((_e7638 * _e7722) - (_e7640 * _e7720));
let _e7732 = ((_e7679 * _e7640) - (_e7681 * _e7638));
let _e7734 = ((_e7726 + _e7729) + _e7732);
let _e7748 = (!(((((_e7726 < 0f) || (_e7729 < 0f)) || (_e7732 < 0f)) && (((_e7726 > 0f) || (_e7729 > 0f)) || (_e7732 > 0f)))) && (_e7734 != 0f));
let _e7756 = select(1e30f, ((((_e7726 * (_e7636 * _e7596)) + (_e7729 * (_e7677 * _e7596))) + (_e7732 * (_e7718 * _e7596))) / select(1f, _e7734, _e7748)), _e7748);
if (_e7756 >= _e7423) {
phi_3742_ = type_26();
phi_3743_ = type_17();
phi_3744_ = true;
} else {
let _e7758 = (_e7650 - _e7609);
let _e7759 = (_e7659 - _e7618);
let _e7760 = (_e7668 - _e7627);
let _e7761 = (_e7691 - _e7609);
let _e7762 = (_e7700 - _e7618);
let _e7763 = (_e7709 - _e7627);
let _e7766 = ((_e7759 * _e7763) - (_e7760 * _e7762));
let _e7769 = ((_e7760 * _e7761) - (_e7758 * _e7763));
let _e7772 = ((_e7758 * _e7762) - (_e7759 * _e7761));
let _e7777 = (((_e7766 * _e7766) + (_e7769 * _e7769)) + (_e7772 * _e7772));
let _e7780 = sqrt(select(0f, _e7777, (_e7777 > 0f)));
let _e7783 = (1f / select(1e-20f, _e7780, (_e7780 > 1e-20f)));
let _e7791 = (((_e1407.member_1.x * (_e7766 * _e7783)) + (_e1407.member_1.y * (_e7769 * _e7783))) + (_e1407.member_1.z * (_e7772 * _e7783)));
let _e7794 = bitcast<f32>((bitcast<u32>(_e7791) & 2147483647u));
let _e7796 = select(1e-3f, _e7794, (_e7794 > 1e-3f));
let _e7797 = (_e7599 + 18i);
let _e7799 = select(_e7601, _e7797, (_e7797 < _e7601));
let _e7805 = global_2.member[bitcast<u32>(select(0i, _e7799, (_e7799 > 0i)))];
let _e7812 = select(0i, select(select(i32(_e7805), i32(-2147483648), (_e7805 < -2147483600f)), 2147483647i, (_e7805 > 2147483500f)), (_e7805 == _e7805));
let _e7813 = (_e7812 * 4i);
let _e7815 = (bitcast<i32>(_e126) - 1i);
let _e7817 = select(_e7815, _e7813, (_e7813 < _e7815));
let _e7823 = global_3.member[bitcast<u32>(select(0i, _e7817, (_e7817 > 0i)))];
let _e7825 = select(_e7823, 1f, (_e7812 == 16i));
let _e7826 = (_e7825 <= 0f);
if _e7826 {
phi_3579_ = 0i;
} else {
phi_3579_ = (1i << bitcast<u32>((_e7812 & 31i)));
}
let _e7831 = phi_3579_;
let _e7832 = (_e7791 < 0f);
let _e7833 = select(_e7831, 0i, _e7832);
let _e7834 = select(0i, _e7831, _e7832);
let _e7843 = (_e7756 * _e7796);
let _e7856 = (((_e7756 > _e1407.member_13) && (_e1407.member_13 > 0f)) || (((_e7843 > (_e7420 * 2f)) || ((((_e7825 == 0f) || ((_e7834 & ~(_e1407.member_7)) != 0i)) || ((_e7833 & _e1407.member_7) != 0i)) && (_e7843 >= -((_e7420 * 0.5f))))) && (_e1407.member_13 <= 0f)));
if _e7856 {
let _e7857 = (_e7756 < _e1407.member_10);
if (_e7273 && ((bitcast<f32>((bitcast<u32>((_e7756 - _e1407.member_10)) & 2147483647u)) * select(_e7414, _e7796, (_e7796 > _e7414))) <= _e7420)) {
let _e7876 = ((_e1407.member_9 * 19i) + 18i);
let _e7878 = select(_e7601, _e7876, (_e7876 < _e7601));
let _e7884 = global_2.member[bitcast<u32>(select(0i, _e7878, (_e7878 > 0i)))];
let _e7891 = select(0i, select(select(i32(_e7884), i32(-2147483648), (_e7884 < -2147483600f)), 2147483647i, (_e7884 > 2147483500f)), (_e7884 == _e7884));
let _e7892 = (_e7891 * 4i);
let _e7894 = select(_e7815, _e7892, (_e7892 < _e7815));
let _e7900 = global_3.member[bitcast<u32>(select(0i, _e7894, (_e7894 > 0i)))];
if (_e7826 != (select(_e7900, 1f, (_e7891 == 16i)) <= 0f)) {
phi_3724_ = _e7826;
} else {
if (!(_e7826) && (_e7812 != _e7891)) {
phi_3723_ = (_e7812 < _e7891);
} else {
phi_3723_ = _e7857;
}
let _e7910 = phi_3723_;
phi_3724_ = _e7910;
}
let _e7912 = phi_3724_;
phi_3730_ = type_26((_e7402 | _e7834), (_e7409 | _e7833), _e1407.member_13, select(_e7756, _e1407.member_14, (_e1407.member_14 > _e7756)), _e7414);
phi_3731_ = _e7912;
} else {
if _e7857 {
phi_3729_ = type_26(_e7834, _e7833, _e1407.member_13, _e7756, _e7414);
} else {
phi_3729_ = _e7415;
}
let _e7869 = phi_3729_;
phi_3730_ = _e7869;
phi_3731_ = _e7857;
}
let _e7914 = phi_3730_;
let _e7916 = phi_3731_;
if _e7916 {
phi_3738_ = type_17(_e1407.member, _e1407.member_1, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), _e7271, _e1407.member_14, 0f, 16i, 0f, 0f, 0f, 0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 0i, _e7580, _e7582, _e7756);
} else {
phi_3738_ = _e7581;
}
let _e7919 = phi_3738_;
phi_3739_ = _e7914;
phi_3740_ = _e7919;
} else {
phi_3739_ = type_26();
phi_3740_ = type_17();
}
let _e7921 = phi_3739_;
let _e7923 = phi_3740_;
phi_3742_ = _e7921;
phi_3743_ = _e7923;
phi_3744_ = select(true, false, _e7856);
}
let _e7926 = phi_3742_;
let _e7928 = phi_3743_;
let _e7930 = phi_3744_;
phi_3748_ = _e7926;
phi_3749_ = _e7928;
phi_3750_ = _e7930;
}
let _e7932 = phi_3748_;
let _e7934 = phi_3749_;
let _e7936 = phi_3750_;
if _e7936 {
phi_3754_ = _e7415;
phi_3755_ = _e7581;
} else {
phi_3754_ = _e7932;
phi_3755_ = _e7934;
}
let _e7938 = phi_3754_;
let _e7940 = phi_3755_;
let _e7969 = type_25(_e1407.member, _e1407.member_1, _e1407.member_2, _e1407.member_3, _e1407.member_4, _e1407.member_5, _e1407.member_6, _e1407.member_7, _e7940.member_15, _e1407.member_9, _e1407.member_10, _e1407.member_11, _e1407.member_12, _e1407.member_13, _e1407.member_14, _e1407.member_15, _e1407.member_16, _e1407.member_17, _e1407.member_18, _e1407.member_19, _e1407.member_20, _e1407.member_21, _e1407.member_22, _e1407.member_23, _e1407.member_24, _e1407.member_25, _e1407.member_26, _e1407.member_27);
let _e7998 = type_25(_e7969.member, _e7969.member_1, _e7969.member_2, _e7969.member_3, _e7969.member_4, _e7969.member_5, _e7969.member_6, _e7969.member_7, _e7969.member_8, _e7940.member_16, _e7969.member_10, _e7969.member_11, _e7969.member_12, _e7969.member_13, _e7969.member_14, _e7969.member_15, _e7969.member_16, _e7969.member_17, _e7969.member_18, _e7969.member_19, _e7969.member_20, _e7969.member_21, _e7969.member_22, _e7969.member_23, _e7969.member_24, _e7969.member_25, _e7969.member_26, _e7969.member_27);
let _e8027 = type_25(_e7998.member, _e7998.member_1, _e7998.member_2, _e7998.member_3, _e7998.member_4, _e7998.member_5, _e7998.member_6, _e7998.member_7, _e7998.member_8, _e7998.member_9, _e7940.member_17, _e7998.member_11, _e7998.member_12, _e7998.member_13, _e7998.member_14, _e7998.member_15, _e7998.member_16, _e7998.member_17, _e7998.member_18, _e7998.member_19, _e7998.member_20, _e7998.member_21, _e7998.member_22, _e7998.member_23, _e7998.member_24, _e7998.member_25, _e7998.member_26, _e7998.member_27);
let _e8056 = type_25(_e8027.member, _e8027.member_1, _e8027.member_2, _e8027.member_3, _e8027.member_4, _e8027.member_5, _e8027.member_6, _e8027.member_7, _e8027.member_8, _e8027.member_9, _e8027.member_10, _e7938.member, _e8027.member_12, _e8027.member_13, _e8027.member_14, _e8027.member_15, _e8027.member_16, _e8027.member_17, _e8027.member_18, _e8027.member_19, _e8027.member_20, _e8027.member_21, _e8027.member_22, _e8027.member_23, _e8027.member_24, _e8027.member_25, _e8027.member_26, _e8027.member_27);
let _e8085 = type_25(_e8056.member, _e8056.member_1, _e8056.member_2, _e8056.member_3, _e8056.member_4, _e8056.member_5, _e8056.member_6, _e8056.member_7, _e8056.member_8, _e8056.member_9, _e8056.member_10, _e8056.member_11, _e7938.member_1, _e8056.member_13, _e8056.member_14, _e8056.member_15, _e8056.member_16, _e8056.member_17, _e8056.member_18, _e8056.member_19, _e8056.member_20, _e8056.member_21, _e8056.member_22, _e8056.member_23, _e8056.member_24, _e8056.member_25, _e8056.member_26, _e8056.member_27);
phi_9411_ = type_25(_e8085.member, _e8085.member_1, _e8085.member_2, _e8085.member_3, _e8085.member_4, _e8085.member_5, _e8085.member_6, _e8085.member_7, _e8085.member_8, _e8085.member_9, _e8085.member_10, _e8085.member_11, _e8085.member_12, _e8085.member_13, _e7938.member_3, _e8085.member_15, _e8085.member_16, _e8085.member_17, _e8085.member_18, _e8085.member_19, _e8085.member_20, _e8085.member_21, _e8085.member_22, _e8085.member_23, _e8085.member_24, _e8085.member_25, _e8085.member_26, _e8085.member_27);
phi_9412_ = _e1411;
} else {
phi_3770_ = 15i;
phi_3773_ = 16i;
loop {
let _e1421 = phi_3770_;
let _e1423 = phi_3773_;
local = _e1423;
local_1 = _e1423;
local_2 = _e1423;
local_4 = _e1423;
local_7 = _e1423;
let _e1424 = (_e1421 >= 0i);
if _e1424 {
phi_3771_ = (_e1421 - 1i);
phi_3774_ = select(_e1423, _e1421, (((_e1407.member_7 >> bitcast<u32>((_e1421 & 31i))) & 1i) == 1i));
} else {
phi_3771_ = i32();
phi_3774_ = i32();
}
let _e1433 = phi_3771_;
let _e1435 = phi_3774_;
continue;
continuing {
phi_3770_ = _e1433;
phi_3773_ = _e1435;
break if !(_e1424);
}
}
let _e1438 = local;
let _e1439 = (_e1438 == 16i);
let _e1451 = (bitcast<i32>(countOneBits(bitcast<u32>((_e1407.member_17 & ((1i << bitcast<u32>((_e1407.member_16 & 31i))) - 1i))))) == _e1407.member_20);
let _e1454 = ((_e1439 && _e1451) && !(_e1411));
if _e1454 {
let _e7228 = type_25(_e1407.member, _e1407.member_1, _e1407.member_2, _e1407.member_3, _e1407.member_4, _e1407.member_5, _e1407.member_6, _e1407.member_7, _e1407.member_8, _e1407.member_9, _e1407.member_10, _e1407.member_11, _e1407.member_12, _e1407.member_13, _e1407.member_14, 2f, _e1407.member_16, _e1407.member_17, _e1407.member_18, _e1407.member_19, _e1407.member_20, _e1407.member_21, _e1407.member_22, _e1407.member_23, _e1407.member_24, _e1407.member_25, _e1407.member_26, _e1407.member_27);
phi_9409_ = type_25(_e7228.member, _e7228.member_1, _e7228.member_2, _e7228.member_3, _e7228.member_4, _e7228.member_5, _e7228.member_6, _e7228.member_7, _e7228.member_8, _e7228.member_9, _e7228.member_10, _e7228.member_11, _e7228.member_12, _e7228.member_13, _e7228.member_14, _e7228.member_15, _e7228.member_16, _e7228.member_17, _e7228.member_18, _e7228.member_19, _e7228.member_20, _e7228.member_21, (_e1407.member_22 + 1i), _e7228.member_23, _e7228.member_24, _e7228.member_25, _e7228.member_26, _e7228.member_27);
} else {
let _e1456 = (_e1407.member_9 >= 0i);
let _e1459 = (_e1407.member_10 - _e1407.member_13);
let _e1461 = select(0f, _e1459, (_e1459 > 0f));
let _e1464 = ((select(0i, _e1407.member_9, _e1456) * 19i) + 18i);
let _e1466 = (bitcast<i32>(_e124) - 1i);
let _e1468 = select(_e1466, _e1464, (_e1464 < _e1466));
let _e1474 = global_2.member[bitcast<u32>(select(0i, _e1468, (_e1468 > 0i)))];
let _e1481 = select(0i, select(select(i32(_e1474), i32(-2147483648), (_e1474 < -2147483600f)), 2147483647i, (_e1474 > 2147483500f)), (_e1474 == _e1474));
let _e1482 = (_e1481 * 4i);
let _e1484 = (bitcast<i32>(_e126) - 1i);
let _e1486 = select(_e1484, _e1482, (_e1482 < _e1484));
let _e1492 = global_3.member[bitcast<u32>(select(0i, _e1486, (_e1486 > 0i)))];
let _e1494 = select(_e1492, 1f, (_e1481 == 16i));
let _e1496 = (_e1456 && (_e1494 <= 0f));
let _e1505 = ((_e1407.member_7 | (_e1407.member_11 & ~(_e1407.member_12))) & ~((_e1407.member_12 & ~(_e1407.member_11))));
phi_3894_ = 15i;
phi_3897_ = 16i;
loop {
let _e1507 = phi_3894_;
let _e1509 = phi_3897_;
local_3 = _e1509;
local_5 = _e1509;
local_6 = _e1509;
local_8 = _e1509;
local_9 = _e1509;
let _e1510 = (_e1507 >= 0i);
if _e1510 {
phi_3895_ = (_e1507 - 1i);
phi_3898_ = select(_e1509, _e1507, (((_e1505 >> bitcast<u32>((_e1507 & 31i))) & 1i) == 1i));
} else {
phi_3895_ = i32();
phi_3898_ = i32();
}
let _e1519 = phi_3895_;
let _e1521 = phi_3898_;
continue;
continuing {
phi_3894_ = _e1519;
phi_3897_ = _e1521;
break if !(_e1510);
}
}
if _e1439 {
let _e1791 = (1f / select(_e1407.member_1.x, select(1e-12f, -1e-12f, (_e1407.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e1407.member_1.x) & 2147483647u)) < 1e-12f)));
let _e1800 = (1f / select(_e1407.member_1.y, select(1e-12f, -1e-12f, (_e1407.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e1407.member_1.y) & 2147483647u)) < 1e-12f)));
let _e1809 = (1f / select(_e1407.member_1.z, select(1e-12f, -1e-12f, (_e1407.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e1407.member_1.z) & 2147483647u)) < 1e-12f)));
let _e1813 = global_5.member.member_13.member_4;
let _e1820 = global_5.member.member_13.member_5;
let _e1826 = ((_e1813.member - _e1407.member.x) * _e1791);
let _e1828 = ((_e1820.member - _e1407.member.x) * _e1791);
let _e1831 = ((_e1813.member_1 - _e1407.member.y) * _e1800);
let _e1833 = ((_e1820.member_1 - _e1407.member.y) * _e1800);
let _e1836 = ((_e1813.member_2 - _e1407.member.z) * _e1809);
let _e1838 = ((_e1820.member_2 - _e1407.member.z) * _e1809);
let _e1840 = select(_e1828, _e1826, (_e1826 < _e1828));
let _e1842 = select(_e1833, _e1831, (_e1831 < _e1833));
let _e1844 = select(_e1842, _e1840, (_e1840 > _e1842));
let _e1846 = select(_e1838, _e1836, (_e1836 < _e1838));
let _e1848 = select(_e1846, _e1844, (_e1844 > _e1846));
let _e1850 = select(_e1828, _e1826, (_e1826 > _e1828));
let _e1852 = select(_e1833, _e1831, (_e1831 > _e1833));
let _e1854 = select(_e1852, _e1850, (_e1850 < _e1852));
let _e1856 = select(_e1838, _e1836, (_e1836 > _e1838));
let _e1858 = select(_e1856, _e1854, (_e1854 < _e1856));
let _e1860 = select(0f, _e1848, (_e1848 > 0f));
let _e1862 = select(_e1407.member_10, _e1858, (_e1858 < _e1407.member_10));
let _e1865 = (select(_e1860, _e1862, (_e1862 > _e1860)) - _e1860);
let _e1869 = global_5.member.member_13.member;
let _e1874 = -((_e1869.member * _e1865));
let _e1876 = select(-87f, _e1874, (_e1874 > -87f));
let _e1878 = select(88f, _e1876, (_e1876 < 88f));
let _e1880 = ((_e1878 * 1.442695f) + 0.5f);
let _e1882 = select(-127f, _e1880, (_e1880 > -127f));
let _e1884 = select(128f, _e1882, (_e1882 < 128f));
let _e1891 = select(0i, select(select(i32(_e1884), i32(-2147483648), (_e1884 < -2147483600f)), 2147483647i, (_e1884 > 2147483500f)), (_e1884 == _e1884));
let _e1895 = (_e1891 - select(0i, 1i, (_e1884 < f32(_e1891))));
let _e1896 = f32(_e1895);
let _e1900 = ((_e1878 - (_e1896 * 0.6933594f)) - (_e1896 * -2.1219444e-4f));
let _e1922 = -((_e1869.member_1 * _e1865));
let _e1924 = select(-87f, _e1922, (_e1922 > -87f));
let _e1926 = select(88f, _e1924, (_e1924 < 88f));
let _e1928 = ((_e1926 * 1.442695f) + 0.5f);
let _e1930 = select(-127f, _e1928, (_e1928 > -127f));
let _e1932 = select(128f, _e1930, (_e1930 < 128f));
let _e1939 = select(0i, select(select(i32(_e1932), i32(-2147483648), (_e1932 < -2147483600f)), 2147483647i, (_e1932 > 2147483500f)), (_e1932 == _e1932));
let _e1943 = (_e1939 - select(0i, 1i, (_e1932 < f32(_e1939))));
let _e1944 = f32(_e1943);
let _e1948 = ((_e1926 - (_e1944 * 0.6933594f)) - (_e1944 * -2.1219444e-4f));
let _e1970 = -((_e1869.member_2 * _e1865));
let _e1972 = select(-87f, _e1970, (_e1970 > -87f));
let _e1974 = select(88f, _e1972, (_e1972 < 88f));
let _e1976 = ((_e1974 * 1.442695f) + 0.5f);
let _e1978 = select(-127f, _e1976, (_e1976 > -127f));
let _e1980 = select(128f, _e1978, (_e1978 < 128f));
let _e1987 = select(0i, select(select(i32(_e1980), i32(-2147483648), (_e1980 < -2147483600f)), 2147483647i, (_e1980 > 2147483500f)), (_e1980 == _e1980));
let _e1991 = (_e1987 - select(0i, 1i, (_e1980 < f32(_e1987))));
let _e1992 = f32(_e1991);
let _e1996 = ((_e1974 - (_e1992 * 0.6933594f)) - (_e1992 * -2.1219444e-4f));
let _e2023 = (1f / 3f);
let _e2027 = (_e1407.member_6.x * ((1f + (_e1900 * (1f + (_e1900 * (0.5f + (_e1900 * (0.16666667f + (_e1900 * (0.041666668f + (_e1900 * (0.008333334f + (_e1900 * (0.001388889f + (_e1900 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1895 + 127i)) << bitcast<u32>(23i)))));
let _e2030 = (_e1407.member_6.y * ((1f + (_e1948 * (1f + (_e1948 * (0.5f + (_e1948 * (0.16666667f + (_e1948 * (0.041666668f + (_e1948 * (0.008333334f + (_e1948 * (0.001388889f + (_e1948 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1943 + 127i)) << bitcast<u32>(23i)))));
let _e2033 = (_e1407.member_6.z * ((1f + (_e1996 * (1f + (_e1996 * (0.5f + (_e1996 * (0.16666667f + (_e1996 * (0.041666668f + (_e1996 * (0.008333334f + (_e1996 * (0.001388889f + (_e1996 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1991 + 127i)) << bitcast<u32>(23i)))));
let _e2062 = type_25(_e1407.member, _e1407.member_1, _e1407.member_2, _e1407.member_3, _e1407.member_4, _e1407.member_5, vec3<f32>(_e2027, _e2030, _e2033), _e1407.member_7, _e1407.member_8, _e1407.member_9, _e1407.member_10, _e1407.member_11, _e1407.member_12, _e1407.member_13, _e1407.member_14, _e1407.member_15, _e1407.member_16, _e1407.member_17, _e1407.member_18, _e1407.member_19, _e1407.member_20, _e1407.member_21, _e1407.member_22, _e1407.member_23, _e1407.member_24, _e1407.member_25, _e1407.member_26, _e1407.member_27);
if _e1451 {
phi_4293_ = ((((_e1407.member_6.x + _e1407.member_6.y) + _e1407.member_6.z) * _e2023) - (((_e2027 + _e2030) + _e2033) * _e2023));
} else {
phi_4293_ = 0f;
}
let _e2068 = phi_4293_;
phi_4583_ = type_25(_e2062.member, _e2062.member_1, _e2062.member_2, _e2062.member_3, _e2062.member_4, _e2062.member_5, _e2062.member_6, _e2062.member_7, _e2062.member_8, _e2062.member_9, _e2062.member_10, _e2062.member_11, _e2062.member_12, _e2062.member_13, _e2062.member_14, _e2062.member_15, _e2062.member_16, _e2062.member_17, _e2062.member_18, _e2062.member_19, _e2062.member_20, _e2062.member_21, _e2062.member_22, _e2062.member_23, _e2062.member_24, _e2062.member_25, (_e1407.member_26 + _e2068), _e2062.member_27);
} else {
let _e1524 = select(1e6f, _e1461, (_e1461 < 1e6f));
let _e1526 = local_1;
let _e1527 = (_e1526 * 4i);
let _e1528 = (_e1527 + 1i);
let _e1530 = select(_e1484, _e1528, (_e1528 < _e1484));
let _e1536 = global_3.member[bitcast<u32>(select(0i, _e1530, (_e1530 > 0i)))];
let _e1538 = -((_e1536 * _e1524));
let _e1540 = select(-87f, _e1538, (_e1538 > -87f));
let _e1542 = select(88f, _e1540, (_e1540 < 88f));
let _e1544 = ((_e1542 * 1.442695f) + 0.5f);
let _e1546 = select(-127f, _e1544, (_e1544 > -127f));
let _e1548 = select(128f, _e1546, (_e1546 < 128f));
let _e1555 = select(0i, select(select(i32(_e1548), i32(-2147483648), (_e1548 < -2147483600f)), 2147483647i, (_e1548 > 2147483500f)), (_e1548 == _e1548));
let _e1559 = (_e1555 - select(0i, 1i, (_e1548 < f32(_e1555))));
let _e1560 = f32(_e1559);
let _e1564 = ((_e1542 - (_e1560 * 0.6933594f)) - (_e1560 * -2.1219444e-4f));
let _e1585 = (_e1527 + 2i);
let _e1587 = select(_e1484, _e1585, (_e1585 < _e1484));
let _e1593 = global_3.member[bitcast<u32>(select(0i, _e1587, (_e1587 > 0i)))];
let _e1595 = -((_e1593 * _e1524));
let _e1597 = select(-87f, _e1595, (_e1595 > -87f));
let _e1599 = select(88f, _e1597, (_e1597 < 88f));
let _e1601 = ((_e1599 * 1.442695f) + 0.5f);
let _e1603 = select(-127f, _e1601, (_e1601 > -127f));
let _e1605 = select(128f, _e1603, (_e1603 < 128f));
let _e1612 = select(0i, select(select(i32(_e1605), i32(-2147483648), (_e1605 < -2147483600f)), 2147483647i, (_e1605 > 2147483500f)), (_e1605 == _e1605));
let _e1616 = (_e1612 - select(0i, 1i, (_e1605 < f32(_e1612))));
let _e1617 = f32(_e1616);
let _e1621 = ((_e1599 - (_e1617 * 0.6933594f)) - (_e1617 * -2.1219444e-4f));
let _e1642 = (_e1527 + 3i);
let _e1644 = select(_e1484, _e1642, (_e1642 < _e1484));
let _e1650 = global_3.member[bitcast<u32>(select(0i, _e1644, (_e1644 > 0i)))];
let _e1652 = -((_e1650 * _e1524));
let _e1654 = select(-87f, _e1652, (_e1652 > -87f));
let _e1656 = select(88f, _e1654, (_e1654 < 88f));
let _e1658 = ((_e1656 * 1.442695f) + 0.5f);
let _e1660 = select(-127f, _e1658, (_e1658 > -127f));
let _e1662 = select(128f, _e1660, (_e1660 < 128f));
let _e1669 = select(0i, select(select(i32(_e1662), i32(-2147483648), (_e1662 < -2147483600f)), 2147483647i, (_e1662 > 2147483500f)), (_e1662 == _e1662));
let _e1673 = (_e1669 - select(0i, 1i, (_e1662 < f32(_e1669))));
let _e1674 = f32(_e1673);
let _e1678 = ((_e1656 - (_e1674 * 0.6933594f)) - (_e1674 * -2.1219444e-4f));
let _e1705 = (1f / 3f);
let _e1709 = (_e1407.member_6.x * ((1f + (_e1564 * (1f + (_e1564 * (0.5f + (_e1564 * (0.16666667f + (_e1564 * (0.041666668f + (_e1564 * (0.008333334f + (_e1564 * (0.001388889f + (_e1564 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1559 + 127i)) << bitcast<u32>(23i)))));
let _e1712 = (_e1407.member_6.y * ((1f + (_e1621 * (1f + (_e1621 * (0.5f + (_e1621 * (0.16666667f + (_e1621 * (0.041666668f + (_e1621 * (0.008333334f + (_e1621 * (0.001388889f + (_e1621 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1616 + 127i)) << bitcast<u32>(23i)))));
let _e1715 = (_e1407.member_6.z * ((1f + (_e1678 * (1f + (_e1678 * (0.5f + (_e1678 * (0.16666667f + (_e1678 * (0.041666668f + (_e1678 * (0.008333334f + (_e1678 * (0.001388889f + (_e1678 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1673 + 127i)) << bitcast<u32>(23i)))));
let _e1744 = type_25(_e1407.member, _e1407.member_1, _e1407.member_2, _e1407.member_3, _e1407.member_4, _e1407.member_5, vec3<f32>(_e1709, _e1712, _e1715), _e1407.member_7, _e1407.member_8, _e1407.member_9, _e1407.member_10, _e1407.member_11, _e1407.member_12, _e1407.member_13, _e1407.member_14, _e1407.member_15, _e1407.member_16, _e1407.member_17, _e1407.member_18, _e1407.member_19, _e1407.member_20, _e1407.member_21, _e1407.member_22, _e1407.member_23, _e1407.member_24, _e1407.member_25, _e1407.member_26, _e1407.member_27);
if _e1451 {
phi_4579_ = ((((_e1407.member_6.x + _e1407.member_6.y) + _e1407.member_6.z) * _e1705) - (((_e1709 + _e1712) + _e1715) * _e1705));
} else {
phi_4579_ = 0f;
}
let _e1750 = phi_4579_;
phi_4583_ = type_25(_e1744.member, _e1744.member_1, _e1744.member_2, _e1744.member_3, _e1744.member_4, _e1744.member_5, _e1744.member_6, _e1744.member_7, _e1744.member_8, _e1744.member_9, _e1744.member_10, _e1744.member_11, _e1744.member_12, _e1744.member_13, _e1744.member_14, _e1744.member_15, _e1744.member_16, _e1744.member_17, _e1744.member_18, _e1744.member_19, _e1744.member_20, _e1744.member_21, _e1744.member_22, _e1744.member_23, _e1744.member_24, (_e1407.member_25 + _e1750), _e1744.member_26, _e1744.member_27);
}
let _e2100 = phi_4583_;
if (!(_e1456) || (_e1496 && (_e1494 == 0f))) {
if (bitcast<i32>(countOneBits(bitcast<u32>((_e2100.member_17 & ((1i << bitcast<u32>((_e2100.member_16 & 31i))) - 1i))))) == _e2100.member_20) {
phi_4637_ = (((_e2100.member_6.x + _e2100.member_6.y) + _e2100.member_6.z) * (1f / 3f));
} else {
phi_4637_ = 0f;
}
let _e5812 = phi_4637_;
if (_e2100.member_9 == -1i) {
phi_4649_ = type_25(_e2100.member, _e2100.member_1, _e2100.member_2, _e2100.member_3, _e2100.member_4, _e2100.member_5, _e2100.member_6, _e2100.member_7, _e2100.member_8, _e2100.member_9, _e2100.member_10, _e2100.member_11, _e2100.member_12, _e2100.member_13, _e2100.member_14, _e2100.member_15, _e2100.member_16, _e2100.member_17, _e2100.member_18, _e2100.member_19, _e2100.member_20, _e2100.member_21, _e2100.member_22, (_e2100.member_23 + _e5812), _e2100.member_24, _e2100.member_25, _e2100.member_26, _e2100.member_27);
} else {
phi_4649_ = type_25(_e2100.member, _e2100.member_1, _e2100.member_2, _e2100.member_3, _e2100.member_4, _e2100.member_5, _e2100.member_6, _e2100.member_7, _e2100.member_8, _e2100.member_9, _e2100.member_10, _e2100.member_11, _e2100.member_12, _e2100.member_13, _e2100.member_14, _e2100.member_15, _e2100.member_16, _e2100.member_17, _e2100.member_18, _e2100.member_19, _e2100.member_20, _e2100.member_21, _e2100.member_22, _e2100.member_23, (_e2100.member_24 + _e5812), _e2100.member_25, _e2100.member_26, _e2100.member_27);
}
let _e5876 = phi_4649_;
let _e5878 = (_e5876.member_18 == 0i);
if (_e5878 && (_e5876.member_21 == 0i)) {
phi_5949_ = type_25(_e5876.member, _e5876.member_1, _e5876.member_2, _e5876.member_3, _e5876.member_4, _e5876.member_5, _e5876.member_6, _e5876.member_7, _e5876.member_8, _e5876.member_9, _e5876.member_10, _e5876.member_11, _e5876.member_12, _e5876.member_13, _e5876.member_14, 3f, _e5876.member_16, _e5876.member_17, _e5876.member_18, _e5876.member_19, _e5876.member_20, _e5876.member_21, _e5876.member_22, _e5876.member_23, _e5876.member_24, _e5876.member_25, _e5876.member_26, _e5876.member_27);
} else {
if _e5878 {
let _e6010 = type_25(_e5876.member, _e5876.member_1, _e5876.member_2, _e5876.member_3, _e5876.member_4, _e5876.member_5, _e5876.member_6, _e5876.member_7, _e5876.member_8, _e5876.member_9, _e5876.member_10, _e5876.member_11, _e5876.member_12, _e5876.member_13, _e5876.member_14, _e5876.member_15, _e5876.member_16, _e5876.member_17, _e5876.member_18, _e5876.member_19, (_e5876.member_20 + 1i), _e5876.member_21, _e5876.member_22, _e5876.member_23, _e5876.member_24, _e5876.member_25, _e5876.member_26, _e5876.member_27);
let _e6038 = type_25(_e6010.member, _e6010.member_1, _e6010.member_2, _e6010.member_3, _e6010.member_4, _e6010.member_5, _e6010.member_6, _e6010.member_7, _e6010.member_8, _e6010.member_9, _e6010.member_10, _e6010.member_11, _e6010.member_12, _e6010.member_13, _e6010.member_14, _e6010.member_15, _e6010.member_16, _e6010.member_17, _e6010.member_18, _e6010.member_19, _e6010.member_20, 0i, _e6010.member_22, _e6010.member_23, _e6010.member_24, _e6010.member_25, _e6010.member_26, _e6010.member_27);
let _e6066 = type_25(_e6038.member, _e6038.member_1, _e6038.member_2, _e6038.member_3, _e6038.member_4, _e6038.member_5, _e6038.member_6, _e6038.member_7, _e6038.member_8, _e6038.member_9, _e6038.member_10, _e6038.member_11, _e6038.member_12, _e6038.member_13, _e6038.member_14, _e6038.member_15, _e6038.member_16, 0i, _e6038.member_18, _e6038.member_19, _e6038.member_20, _e6038.member_21, _e6038.member_22, _e6038.member_23, _e6038.member_24, _e6038.member_25, _e6038.member_26, _e6038.member_27);
phi_4690_ = type_25(_e6066.member, _e6066.member_1, _e6066.member_2, _e6066.member_3, _e6066.member_4, _e6066.member_5, _e6066.member_6, _e6066.member_7, _e6066.member_8, _e6066.member_9, _e6066.member_10, _e6066.member_11, _e6066.member_12, _e6066.member_13, _e6066.member_14, _e6066.member_15, _e6066.member_16, _e6066.member_17, _e6066.member_18, 0i, _e6066.member_20, _e6066.member_21, _e6066.member_22, _e6066.member_23, _e6066.member_24, _e6066.member_25, _e6066.member_26, _e6066.member_27);
} else {
let _e5886 = bitcast<i32>((bitcast<u32>(f32(_e5876.member_18)) >> bitcast<u32>(23i)));
let _e5890 = (1i << bitcast<u32>(((_e5886 - 127i) & 31i)));
let _e5891 = (_e5890 - 1i);
let _e5922 = type_25(_e5876.member, _e5876.member_1, _e5876.member_2, _e5876.member_3, _e5876.member_4, _e5876.member_5, _e5876.member_6, _e5876.member_7, _e5876.member_8, _e5876.member_9, _e5876.member_10, _e5876.member_11, _e5876.member_12, _e5876.member_13, _e5876.member_14, _e5876.member_15, _e5876.member_16, ((_e5876.member_17 & _e5891) | _e5890), _e5876.member_18, _e5876.member_19, _e5876.member_20, _e5876.member_21, _e5876.member_22, _e5876.member_23, _e5876.member_24, _e5876.member_25, _e5876.member_26, _e5876.member_27);
let _e5951 = type_25(_e5922.member, _e5922.member_1, _e5922.member_2, _e5922.member_3, _e5922.member_4, _e5922.member_5, _e5922.member_6, _e5922.member_7, _e5922.member_8, _e5922.member_9, _e5922.member_10, _e5922.member_11, _e5922.member_12, _e5922.member_13, _e5922.member_14, _e5922.member_15, _e5922.member_16, _e5922.member_17, (_e5876.member_18 & _e5891), _e5922.member_19, _e5922.member_20, _e5922.member_21, _e5922.member_22, _e5922.member_23, _e5922.member_24, _e5922.member_25, _e5922.member_26, _e5922.member_27);
phi_4690_ = type_25(_e5951.member, _e5951.member_1, _e5951.member_2, _e5951.member_3, _e5951.member_4, _e5951.member_5, _e5951.member_6, _e5951.member_7, _e5951.member_8, _e5951.member_9, _e5951.member_10, _e5951.member_11, _e5951.member_12, _e5951.member_13, _e5951.member_14, _e5951.member_15, _e5951.member_16, _e5951.member_17, _e5951.member_18, (_e5886 + -126i), _e5951.member_20, _e5951.member_21, _e5951.member_22, _e5951.member_23, _e5951.member_24, _e5951.member_25, _e5951.member_26, _e5951.member_27);
}
let _e6096 = phi_4690_;
let _e6102 = global_5.member.member_11.member_2;
let _e6109 = global_5.member.member_11.member_3;
let _e6116 = global_5.member.member_11.member_5;
let _e6122 = global_5.member.member_11.member_7;
let _e6124 = (_e6116 + ((f32(bitcast<i32>(_e120.x)) + 0.5f) * _e6122));
let _e6128 = global_5.member.member_11.member_6;
let _e6134 = global_5.member.member_11.member_8;
let _e6136 = (_e6128 + ((f32(bitcast<i32>(_e120.y)) + 0.5f) * _e6134));
let _e6137 = (_e6102.member * _e6122);
let _e6138 = (_e6102.member_1 * _e6122);
let _e6139 = (_e6102.member_2 * _e6122);
let _e6140 = (_e6109.member * _e6134);
let _e6141 = (_e6109.member_1 * _e6134);
let _e6142 = (_e6109.member_2 * _e6134);
let _e6149 = ((_e6102.member * _e6124) + (_e6109.member * _e6136));
let _e6150 = ((_e6102.member_1 * _e6124) + (_e6109.member_1 * _e6136));
let _e6151 = ((_e6102.member_2 * _e6124) + (_e6109.member_2 * _e6136));
let _e6155 = global_5.member.member_11.member_4;
let _e6162 = global_5.member.member_11.member_1;
let _e6169 = global_5.member.member_10.member;
let _e6170 = (_e6169 == 0u);
let _e6171 = (_e6162.member + _e6149);
let _e6172 = (_e6162.member_1 + _e6150);
let _e6173 = (_e6162.member_2 + _e6151);
let _e6178 = (((_e6171 * _e6171) + (_e6172 * _e6172)) + (_e6173 * _e6173));
let _e6182 = (1f / sqrt(select(0f, _e6178, (_e6178 > 0f))));
let _e6186 = select((_e6171 * _e6182), _e6162.member, _e6170);
let _e6187 = select((_e6172 * _e6182), _e6162.member_1, _e6170);
let _e6188 = select((_e6173 * _e6182), _e6162.member_2, _e6170);
let _e6193 = select(_e6155.member, (_e6155.member + _e6149), _e6170);
let _e6194 = select(_e6155.member_1, (_e6155.member_1 + _e6150), _e6170);
let _e6195 = select(_e6155.member_2, (_e6155.member_2 + _e6151), _e6170);
let _e6209 = (((_e6137 * _e6186) + (_e6138 * _e6187)) + (_e6139 * _e6188));
let _e6219 = select(((_e6137 - (_e6186 * _e6209)) * _e6182), 0f, _e6170);
let _e6220 = select(((_e6138 - (_e6187 * _e6209)) * _e6182), 0f, _e6170);
let _e6221 = select(((_e6139 - (_e6188 * _e6209)) * _e6182), 0f, _e6170);
let _e6227 = (((_e6140 * _e6186) + (_e6141 * _e6187)) + (_e6142 * _e6188));
let _e6237 = select(((_e6140 - (_e6186 * _e6227)) * _e6182), 0f, _e6170);
let _e6238 = select(((_e6141 - (_e6187 * _e6227)) * _e6182), 0f, _e6170);
let _e6239 = select(((_e6142 - (_e6188 * _e6227)) * _e6182), 0f, _e6170);
let _e6248 = (1f / select(_e6186, select(1e-12f, -1e-12f, (_e6186 < 0f)), (bitcast<f32>((bitcast<u32>(_e6186) & 2147483647u)) < 1e-12f)));
let _e6256 = (1f / select(_e6187, select(1e-12f, -1e-12f, (_e6187 < 0f)), (bitcast<f32>((bitcast<u32>(_e6187) & 2147483647u)) < 1e-12f)));
let _e6264 = (1f / select(_e6188, select(1e-12f, -1e-12f, (_e6188 < 0f)), (bitcast<f32>((bitcast<u32>(_e6188) & 2147483647u)) < 1e-12f)));
let _e6267 = global_5.member.member_8;
let _e6273 = global_5.member.member_9;
let _e6278 = ((_e6267.member - _e6193) * _e6248);
let _e6280 = ((_e6273.member - _e6193) * _e6248);
let _e6282 = ((_e6267.member_1 - _e6194) * _e6256);
let _e6284 = ((_e6273.member_1 - _e6194) * _e6256);
let _e6286 = ((_e6267.member_2 - _e6195) * _e6264);
let _e6288 = ((_e6273.member_2 - _e6195) * _e6264);
let _e6290 = select(_e6280, _e6278, (_e6278 < _e6280));
let _e6292 = select(_e6284, _e6282, (_e6282 < _e6284));
let _e6294 = select(_e6292, _e6290, (_e6290 > _e6292));
let _e6296 = select(_e6288, _e6286, (_e6286 < _e6288));
let _e6298 = select(_e6296, _e6294, (_e6294 > _e6296));
let _e6300 = select(_e6280, _e6278, (_e6278 > _e6280));
let _e6302 = select(_e6284, _e6282, (_e6282 > _e6284));
let _e6304 = select(_e6302, _e6300, (_e6300 < _e6302));
let _e6306 = select(_e6288, _e6286, (_e6286 > _e6288));
if (true && _e6170) {
phi_5274_ = -(1e30f);
} else {
phi_5274_ = 0f;
}
let _e6312 = phi_5274_;
let _e6314 = select(_e6312, _e6298, (_e6298 > _e6312));
let _e6316 = ((select(_e6306, _e6304, (_e6304 < _e6306)) <= _e6314) || false);
let _e6317 = select(_e6314, 0f, _e6316);
let _e6318 = (_e6186 * _e6317);
let _e6319 = (_e6187 * _e6317);
let _e6320 = (_e6188 * _e6317);
let _e6321 = (_e6193 + _e6318);
let _e6322 = (_e6194 + _e6319);
let _e6323 = (_e6195 + _e6320);
let _e6353 = type_25((vec3<f32>(_e6193, _e6194, _e6195) + vec3<f32>(_e6318, _e6319, _e6320)), _e6096.member_1, _e6096.member_2, _e6096.member_3, _e6096.member_4, _e6096.member_5, _e6096.member_6, _e6096.member_7, _e6096.member_8, _e6096.member_9, _e6096.member_10, _e6096.member_11, _e6096.member_12, _e6096.member_13, _e6096.member_14, _e6096.member_15, _e6096.member_16, _e6096.member_17, _e6096.member_18, _e6096.member_19, _e6096.member_20, _e6096.member_21, _e6096.member_22, _e6096.member_23, _e6096.member_24, _e6096.member_25, _e6096.member_26, _e6096.member_27);
let _e6381 = type_25(_e6353.member, vec3<f32>(_e6186, _e6187, _e6188), _e6353.member_2, _e6353.member_3, _e6353.member_4, _e6353.member_5, _e6353.member_6, _e6353.member_7, _e6353.member_8, _e6353.member_9, _e6353.member_10, _e6353.member_11, _e6353.member_12, _e6353.member_13, _e6353.member_14, _e6353.member_15, _e6353.member_16, _e6353.member_17, _e6353.member_18, _e6353.member_19, _e6353.member_20, _e6353.member_21, _e6353.member_22, _e6353.member_23, _e6353.member_24, _e6353.member_25, _e6353.member_26, _e6353.member_27);
let _e6419 = type_25(_e6381.member, _e6381.member_1, (vec3<f32>(select(0f, _e6137, _e6170), select(0f, _e6138, _e6170), select(0f, _e6139, _e6170)) + vec3<f32>((_e6219 * _e6317), (_e6220 * _e6317), (_e6221 * _e6317))), _e6381.member_3, _e6381.member_4, _e6381.member_5, _e6381.member_6, _e6381.member_7, _e6381.member_8, _e6381.member_9, _e6381.member_10, _e6381.member_11, _e6381.member_12, _e6381.member_13, _e6381.member_14, _e6381.member_15, _e6381.member_16, _e6381.member_17, _e6381.member_18, _e6381.member_19, _e6381.member_20, _e6381.member_21, _e6381.member_22, _e6381.member_23, _e6381.member_24, _e6381.member_25, _e6381.member_26, _e6381.member_27);
let _e6447 = type_25(_e6419.member, _e6419.member_1, _e6419.member_2, (vec3<f32>(select(0f, _e6140, _e6170), select(0f, _e6141, _e6170), select(0f, _e6142, _e6170)) + vec3<f32>((_e6237 * _e6317), (_e6238 * _e6317), (_e6239 * _e6317))), _e6419.member_4, _e6419.member_5, _e6419.member_6, _e6419.member_7, _e6419.member_8, _e6419.member_9, _e6419.member_10, _e6419.member_11, _e6419.member_12, _e6419.member_13, _e6419.member_14, _e6419.member_15, _e6419.member_16, _e6419.member_17, _e6419.member_18, _e6419.member_19, _e6419.member_20, _e6419.member_21, _e6419.member_22, _e6419.member_23, _e6419.member_24, _e6419.member_25, _e6419.member_26, _e6419.member_27);
let _e6475 = type_25(_e6447.member, _e6447.member_1, _e6447.member_2, _e6447.member_3, vec3<f32>(_e6219, _e6220, _e6221), _e6447.member_5, _e6447.member_6, _e6447.member_7, _e6447.member_8, _e6447.member_9, _e6447.member_10, _e6447.member_11, _e6447.member_12, _e6447.member_13, _e6447.member_14, _e6447.member_15, _e6447.member_16, _e6447.member_17, _e6447.member_18, _e6447.member_19, _e6447.member_20, _e6447.member_21, _e6447.member_22, _e6447.member_23, _e6447.member_24, _e6447.member_25, _e6447.member_26, _e6447.member_27);
let _e6503 = type_25(_e6475.member, _e6475.member_1, _e6475.member_2, _e6475.member_3, _e6475.member_4, vec3<f32>(_e6237, _e6238, _e6239), _e6475.member_6, _e6475.member_7, _e6475.member_8, _e6475.member_9, _e6475.member_10, _e6475.member_11, _e6475.member_12, _e6475.member_13, _e6475.member_14, _e6475.member_15, _e6475.member_16, _e6475.member_17, _e6475.member_18, _e6475.member_19, _e6475.member_20, _e6475.member_21, _e6475.member_22, _e6475.member_23, _e6475.member_24, _e6475.member_25, _e6475.member_26, _e6475.member_27);
let _e6531 = type_25(_e6503.member, _e6503.member_1, _e6503.member_2, _e6503.member_3, _e6503.member_4, _e6503.member_5, _e6503.member_6, 0i, _e6503.member_8, _e6503.member_9, _e6503.member_10, _e6503.member_11, _e6503.member_12, _e6503.member_13, _e6503.member_14, _e6503.member_15, _e6503.member_16, _e6503.member_17, _e6503.member_18, _e6503.member_19, _e6503.member_20, _e6503.member_21, _e6503.member_22, _e6503.member_23, _e6503.member_24, _e6503.member_25, _e6503.member_26, _e6503.member_27);
let _e6559 = type_25(_e6531.member, _e6531.member_1, _e6531.member_2, _e6531.member_3, _e6531.member_4, _e6531.member_5, _e6531.member_6, _e6531.member_7, _e6531.member_8, _e6531.member_9, _e6531.member_10, _e6531.member_11, _e6531.member_12, _e6531.member_13, _e6531.member_14, _e6531.member_15, 0i, _e6531.member_17, _e6531.member_18, _e6531.member_19, _e6531.member_20, _e6531.member_21, _e6531.member_22, _e6531.member_23, _e6531.member_24, _e6531.member_25, _e6531.member_26, _e6531.member_27);
let _e6587 = type_25(_e6559.member, _e6559.member_1, _e6559.member_2, _e6559.member_3, _e6559.member_4, _e6559.member_5, _e6559.member_6, _e6559.member_7, _e6559.member_8, _e6559.member_9, _e6559.member_10, _e6559.member_11, _e6559.member_12, _e6559.member_13, _e6559.member_14, 1f, _e6559.member_16, _e6559.member_17, _e6559.member_18, _e6559.member_19, _e6559.member_20, _e6559.member_21, _e6559.member_22, _e6559.member_23, _e6559.member_24, _e6559.member_25, _e6559.member_26, _e6559.member_27);
let _e6592 = global_5.member.member_14.member.member;
let _e6603 = ((((_e6592.member.member * _e6321) + (_e6592.member.member_1 * _e6322)) + (_e6592.member.member_2 * _e6323)) + _e6592.member_1);
let _e6609 = -((((_e6592.member.member * _e6186) + (_e6592.member.member_1 * _e6187)) + (_e6592.member.member_2 * _e6188)));
let _e6611 = (_e6609 > 1e-9f);
let _e6615 = ((_e6603 / select(1e-9f, _e6609, _e6611)) - 0.015625f);
let _e6618 = select(1e30f, select(0f, _e6615, (_e6615 > 0f)), ((_e6603 > 0f) && _e6611));
let _e6623 = global_5.member.member_14.member_1.member;
let _e6634 = ((((_e6623.member.member * _e6321) + (_e6623.member.member_1 * _e6322)) + (_e6623.member.member_2 * _e6323)) + _e6623.member_1);
let _e6640 = -((((_e6623.member.member * _e6186) + (_e6623.member.member_1 * _e6187)) + (_e6623.member.member_2 * _e6188)));
let _e6642 = (_e6640 > 1e-9f);
let _e6646 = ((_e6634 / select(1e-9f, _e6640, _e6642)) - 0.015625f);
let _e6649 = select(1e30f, select(0f, _e6646, (_e6646 > 0f)), ((_e6634 > 0f) && _e6642));
let _e6653 = (_e6649 < _e6618);
let _e6684 = type_25(_e6587.member, _e6587.member_1, _e6587.member_2, _e6587.member_3, _e6587.member_4, _e6587.member_5, _e6587.member_6, _e6587.member_7, 0i, _e6587.member_9, _e6587.member_10, _e6587.member_11, _e6587.member_12, _e6587.member_13, _e6587.member_14, _e6587.member_15, _e6587.member_16, _e6587.member_17, _e6587.member_18, _e6587.member_19, _e6587.member_20, _e6587.member_21, _e6587.member_22, _e6587.member_23, _e6587.member_24, _e6587.member_25, _e6587.member_26, _e6587.member_27);
let _e6712 = type_25(_e6684.member, _e6684.member_1, _e6684.member_2, _e6684.member_3, _e6684.member_4, _e6684.member_5, _e6684.member_6, _e6684.member_7, _e6684.member_8, select(select(-2i, -3i, _e6653), -1i, ((_e6618 >= 1e30f) && (_e6649 >= 1e30f))), _e6684.member_10, _e6684.member_11, _e6684.member_12, _e6684.member_13, _e6684.member_14, _e6684.member_15, _e6684.member_16, _e6684.member_17, _e6684.member_18, _e6684.member_19, _e6684.member_20, _e6684.member_21, _e6684.member_22, _e6684.member_23, _e6684.member_24, _e6684.member_25, _e6684.member_26, _e6684.member_27);
let _e6740 = type_25(_e6712.member, _e6712.member_1, _e6712.member_2, _e6712.member_3, _e6712.member_4, _e6712.member_5, _e6712.member_6, _e6712.member_7, _e6712.member_8, _e6712.member_9, select(_e6618, _e6649, _e6653), _e6712.member_11, _e6712.member_12, _e6712.member_13, _e6712.member_14, _e6712.member_15, _e6712.member_16, _e6712.member_17, _e6712.member_18, _e6712.member_19, _e6712.member_20, _e6712.member_21, _e6712.member_22, _e6712.member_23, _e6712.member_24, _e6712.member_25, _e6712.member_26, _e6712.member_27);
let _e6768 = type_25(_e6740.member, _e6740.member_1, _e6740.member_2, _e6740.member_3, _e6740.member_4, _e6740.member_5, _e6740.member_6, _e6740.member_7, _e6740.member_8, _e6740.member_9, _e6740.member_10, _e6740.member_11, _e6740.member_12, 0f, _e6740.member_14, _e6740.member_15, _e6740.member_16, _e6740.member_17, _e6740.member_18, _e6740.member_19, _e6740.member_20, _e6740.member_21, _e6740.member_22, _e6740.member_23, _e6740.member_24, _e6740.member_25, _e6740.member_26, _e6740.member_27);
let _e6796 = type_25(_e6768.member, _e6768.member_1, _e6768.member_2, _e6768.member_3, _e6768.member_4, _e6768.member_5, _e6768.member_6, _e6768.member_7, _e6768.member_8, _e6768.member_9, _e6768.member_10, 0i, _e6768.member_12, _e6768.member_13, _e6768.member_14, _e6768.member_15, _e6768.member_16, _e6768.member_17, _e6768.member_18, _e6768.member_19, _e6768.member_20, _e6768.member_21, _e6768.member_22, _e6768.member_23, _e6768.member_24, _e6768.member_25, _e6768.member_26, _e6768.member_27);
let _e6824 = type_25(_e6796.member, _e6796.member_1, _e6796.member_2, _e6796.member_3, _e6796.member_4, _e6796.member_5, _e6796.member_6, _e6796.member_7, _e6796.member_8, _e6796.member_9, _e6796.member_10, _e6796.member_11, 0i, _e6796.member_13, _e6796.member_14, _e6796.member_15, _e6796.member_16, _e6796.member_17, _e6796.member_18, _e6796.member_19, _e6796.member_20, _e6796.member_21, _e6796.member_22, _e6796.member_23, _e6796.member_24, _e6796.member_25, _e6796.member_26, _e6796.member_27);
let _e6828 = global_5.member.member_13.member_4;
let _e6835 = global_5.member.member_13.member_5;
let _e6840 = ((_e6828.member - _e6193) * _e6248);
let _e6842 = ((_e6835.member - _e6193) * _e6248);
let _e6844 = ((_e6828.member_1 - _e6194) * _e6256);
let _e6846 = ((_e6835.member_1 - _e6194) * _e6256);
let _e6848 = ((_e6828.member_2 - _e6195) * _e6264);
let _e6850 = ((_e6835.member_2 - _e6195) * _e6264);
let _e6852 = select(_e6842, _e6840, (_e6840 < _e6842));
let _e6854 = select(_e6846, _e6844, (_e6844 < _e6846));
let _e6856 = select(_e6854, _e6852, (_e6852 > _e6854));
let _e6858 = select(_e6850, _e6848, (_e6848 < _e6850));
let _e6860 = select(_e6858, _e6856, (_e6856 > _e6858));
let _e6862 = select(_e6842, _e6840, (_e6840 > _e6842));
let _e6864 = select(_e6846, _e6844, (_e6844 > _e6846));
let _e6866 = select(_e6864, _e6862, (_e6862 < _e6864));
let _e6868 = select(_e6850, _e6848, (_e6848 > _e6850));
let _e6870 = select(_e6868, _e6866, (_e6866 < _e6868));
let _e6872 = select(_e6312, _e6860, (_e6860 > _e6312));
let _e6874 = select(_e6317, _e6870, (_e6870 < _e6317));
let _e6877 = (select(_e6872, _e6874, (_e6874 > _e6872)) - _e6872);
let _e6881 = global_5.member.member_13.member;
let _e6886 = -((_e6881.member * _e6877));
let _e6888 = select(-87f, _e6886, (_e6886 > -87f));
let _e6890 = select(88f, _e6888, (_e6888 < 88f));
let _e6892 = ((_e6890 * 1.442695f) + 0.5f);
let _e6894 = select(-127f, _e6892, (_e6892 > -127f));
let _e6896 = select(128f, _e6894, (_e6894 < 128f));
let _e6903 = select(0i, select(select(i32(_e6896), i32(-2147483648), (_e6896 < -2147483600f)), 2147483647i, (_e6896 > 2147483500f)), (_e6896 == _e6896));
let _e6907 = (_e6903 - select(0i, 1i, (_e6896 < f32(_e6903))));
let _e6908 = f32(_e6907);
let _e6912 = ((_e6890 - (_e6908 * 0.6933594f)) - (_e6908 * -2.1219444e-4f));
let _e6934 = -((_e6881.member_1 * _e6877));
let _e6936 = select(-87f, _e6934, (_e6934 > -87f));
let _e6938 = select(88f, _e6936, (_e6936 < 88f));
let _e6940 = ((_e6938 * 1.442695f) + 0.5f);
let _e6942 = select(-127f, _e6940, (_e6940 > -127f));
let _e6944 = select(128f, _e6942, (_e6942 < 128f));
let _e6951 = select(0i, select(select(i32(_e6944), i32(-2147483648), (_e6944 < -2147483600f)), 2147483647i, (_e6944 > 2147483500f)), (_e6944 == _e6944));
let _e6955 = (_e6951 - select(0i, 1i, (_e6944 < f32(_e6951))));
let _e6956 = f32(_e6955);
let _e6960 = ((_e6938 - (_e6956 * 0.6933594f)) - (_e6956 * -2.1219444e-4f));
let _e6982 = -((_e6881.member_2 * _e6877));
let _e6984 = select(-87f, _e6982, (_e6982 > -87f));
let _e6986 = select(88f, _e6984, (_e6984 < 88f));
let _e6988 = ((_e6986 * 1.442695f) + 0.5f);
let _e6990 = select(-127f, _e6988, (_e6988 > -127f));
let _e6992 = select(128f, _e6990, (_e6990 < 128f));
let _e6999 = select(0i, select(select(i32(_e6992), i32(-2147483648), (_e6992 < -2147483600f)), 2147483647i, (_e6992 > 2147483500f)), (_e6992 == _e6992));
let _e7003 = (_e6999 - select(0i, 1i, (_e6992 < f32(_e6999))));
let _e7004 = f32(_e7003);
let _e7008 = ((_e6986 - (_e7004 * 0.6933594f)) - (_e7004 * -2.1219444e-4f));
let _e7031 = (1f / 3f);
let _e7033 = (1f * ((1f + (_e6912 * (1f + (_e6912 * (0.5f + (_e6912 * (0.16666667f + (_e6912 * (0.041666668f + (_e6912 * (0.008333334f + (_e6912 * (0.001388889f + (_e6912 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6907 + 127i)) << bitcast<u32>(23i)))));
let _e7034 = (1f * ((1f + (_e6960 * (1f + (_e6960 * (0.5f + (_e6960 * (0.16666667f + (_e6960 * (0.041666668f + (_e6960 * (0.008333334f + (_e6960 * (0.001388889f + (_e6960 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6955 + 127i)) << bitcast<u32>(23i)))));
let _e7035 = (1f * ((1f + (_e7008 * (1f + (_e7008 * (0.5f + (_e7008 * (0.16666667f + (_e7008 * (0.041666668f + (_e7008 * (0.008333334f + (_e7008 * (0.001388889f + (_e7008 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7003 + 127i)) << bitcast<u32>(23i)))));
let _e7064 = type_25(_e6824.member, _e6824.member_1, _e6824.member_2, _e6824.member_3, _e6824.member_4, _e6824.member_5, vec3<f32>(_e7033, _e7034, _e7035), _e6824.member_7, _e6824.member_8, _e6824.member_9, _e6824.member_10, _e6824.member_11, _e6824.member_12, _e6824.member_13, _e6824.member_14, _e6824.member_15, _e6824.member_16, _e6824.member_17, _e6824.member_18, _e6824.member_19, _e6824.member_20, _e6824.member_21, _e6824.member_22, _e6824.member_23, _e6824.member_24, _e6824.member_25, _e6824.member_26, _e6824.member_27);
if (bitcast<i32>(countOneBits(0u)) == _e6096.member_20) {
phi_5921_ = ((((1f + 1f) + 1f) * _e7031) - (((_e7033 + _e7034) + _e7035) * _e7031));
} else {
phi_5921_ = 0f;
}
let _e7074 = phi_5921_;
let _e7104 = type_25(_e7064.member, _e7064.member_1, _e7064.member_2, _e7064.member_3, _e7064.member_4, _e7064.member_5, _e7064.member_6, _e7064.member_7, _e7064.member_8, _e7064.member_9, _e7064.member_10, _e7064.member_11, _e7064.member_12, _e7064.member_13, _e7064.member_14, _e7064.member_15, _e7064.member_16, _e7064.member_17, _e7064.member_18, _e7064.member_19, _e7064.member_20, _e7064.member_21, _e7064.member_22, _e7064.member_23, _e7064.member_24, _e7064.member_25, (_e6096.member_26 + _e7074), _e7064.member_27);
if _e6316 {
let _e7132 = type_25(_e7104.member, _e7104.member_1, _e7104.member_2, _e7104.member_3, _e7104.member_4, _e7104.member_5, _e7104.member_6, _e7104.member_7, _e1373, _e7104.member_9, _e7104.member_10, _e7104.member_11, _e7104.member_12, _e7104.member_13, _e7104.member_14, _e7104.member_15, _e7104.member_16, _e7104.member_17, _e7104.member_18, _e7104.member_19, _e7104.member_20, _e7104.member_21, _e7104.member_22, _e7104.member_23, _e7104.member_24, _e7104.member_25, _e7104.member_26, _e7104.member_27);
phi_5948_ = type_25(_e7132.member, _e7132.member_1, _e7132.member_2, _e7132.member_3, _e7132.member_4, _e7132.member_5, _e7132.member_6, _e7132.member_7, _e7132.member_8, _e7132.member_9, _e7132.member_10, _e7132.member_11, _e7132.member_12, _e7132.member_13, _e7132.member_14, 3f, _e7132.member_16, _e7132.member_17, _e7132.member_18, _e7132.member_19, _e7132.member_20, _e7132.member_21, _e7132.member_22, _e7132.member_23, _e7132.member_24, _e7132.member_25, _e7132.member_26, _e7132.member_27);
} else {
phi_5948_ = _e7104;
}
let _e7162 = phi_5948_;
phi_5949_ = _e7162;
}
let _e7192 = phi_5949_;
phi_9402_ = _e7192;
phi_9403_ = type_25();
phi_9404_ = true;
} else {
let _e2107 = local_2;
let _e2109 = local_3;
let _e2111 = (!(_e1496) && (_e2107 == _e2109));
if _e2111 {
let _e5538 = type_25(_e2100.member, _e2100.member_1, _e2100.member_2, _e2100.member_3, _e2100.member_4, _e2100.member_5, _e2100.member_6, _e1505, _e2100.member_8, _e2100.member_9, _e2100.member_10, _e2100.member_11, _e2100.member_12, _e2100.member_13, _e2100.member_14, _e2100.member_15, _e2100.member_16, _e2100.member_17, _e2100.member_18, _e2100.member_19, _e2100.member_20, _e2100.member_21, _e2100.member_22, _e2100.member_23, _e2100.member_24, _e2100.member_25, _e2100.member_26, _e2100.member_27);
let _e5569 = type_25(_e5538.member, _e5538.member_1, _e5538.member_2, _e5538.member_3, _e5538.member_4, _e5538.member_5, _e5538.member_6, _e5538.member_7, _e5538.member_8, _e5538.member_9, _e5538.member_10, _e5538.member_11, _e5538.member_12, select(1.1754944e-38f, _e2100.member_14, (_e2100.member_14 > 1.1754944e-38f)), _e5538.member_14, _e5538.member_15, _e5538.member_16, _e5538.member_17, _e5538.member_18, _e5538.member_19, _e5538.member_20, _e5538.member_21, _e5538.member_22, _e5538.member_23, _e5538.member_24, _e5538.member_25, _e5538.member_26, _e5538.member_27);
let _e5597 = type_25(_e5569.member, _e5569.member_1, _e5569.member_2, _e5569.member_3, _e5569.member_4, _e5569.member_5, _e5569.member_6, _e5569.member_7, _e5569.member_8, _e5569.member_9, _e5569.member_10, 0i, _e5569.member_12, _e5569.member_13, _e5569.member_14, _e5569.member_15, _e5569.member_16, _e5569.member_17, _e5569.member_18, _e5569.member_19, _e5569.member_20, _e5569.member_21, _e5569.member_22, _e5569.member_23, _e5569.member_24, _e5569.member_25, _e5569.member_26, _e5569.member_27);
let _e5625 = type_25(_e5597.member, _e5597.member_1, _e5597.member_2, _e5597.member_3, _e5597.member_4, _e5597.member_5, _e5597.member_6, _e5597.member_7, _e5597.member_8, _e5597.member_9, _e5597.member_10, _e5597.member_11, 0i, _e5597.member_13, _e5597.member_14, _e5597.member_15, _e5597.member_16, _e5597.member_17, _e5597.member_18, _e5597.member_19, _e5597.member_20, _e5597.member_21, _e5597.member_22, _e5597.member_23, _e5597.member_24, _e5597.member_25, _e5597.member_26, _e5597.member_27);
let _e5632 = global_5.member.member_14.member.member;
let _e5646 = ((((_e5632.member.member * _e2100.member.x) + (_e5632.member.member_1 * _e2100.member.y)) + (_e5632.member.member_2 * _e2100.member.z)) + _e5632.member_1);
let _e5655 = -((((_e5632.member.member * _e2100.member_1.x) + (_e5632.member.member_1 * _e2100.member_1.y)) + (_e5632.member.member_2 * _e2100.member_1.z)));
let _e5657 = (_e5655 > 1e-9f);
let _e5661 = ((_e5646 / select(1e-9f, _e5655, _e5657)) - 0.015625f);
let _e5664 = select(1e30f, select(0f, _e5661, (_e5661 > 0f)), ((_e5646 > 0f) && _e5657));
let _e5669 = global_5.member.member_14.member_1.member;
let _e5680 = ((((_e5669.member.member * _e2100.member.x) + (_e5669.member.member_1 * _e2100.member.y)) + (_e5669.member.member_2 * _e2100.member.z)) + _e5669.member_1);
let _e5686 = -((((_e5669.member.member * _e2100.member_1.x) + (_e5669.member.member_1 * _e2100.member_1.y)) + (_e5669.member.member_2 * _e2100.member_1.z)));
let _e5688 = (_e5686 > 1e-9f);
let _e5692 = ((_e5680 / select(1e-9f, _e5686, _e5688)) - 0.015625f);
let _e5695 = select(1e30f, select(0f, _e5692, (_e5692 > 0f)), ((_e5680 > 0f) && _e5688));
let _e5699 = (_e5695 < _e5664);
let _e5730 = type_25(_e5625.member, _e5625.member_1, _e5625.member_2, _e5625.member_3, _e5625.member_4, _e5625.member_5, _e5625.member_6, _e5625.member_7, 0i, _e5625.member_9, _e5625.member_10, _e5625.member_11, _e5625.member_12, _e5625.member_13, _e5625.member_14, _e5625.member_15, _e5625.member_16, _e5625.member_17, _e5625.member_18, _e5625.member_19, _e5625.member_20, _e5625.member_21, _e5625.member_22, _e5625.member_23, _e5625.member_24, _e5625.member_25, _e5625.member_26, _e5625.member_27);
let _e5758 = type_25(_e5730.member, _e5730.member_1, _e5730.member_2, _e5730.member_3, _e5730.member_4, _e5730.member_5, _e5730.member_6, _e5730.member_7, _e5730.member_8, select(select(-2i, -3i, _e5699), -1i, ((_e5664 >= 1e30f) && (_e5695 >= 1e30f))), _e5730.member_10, _e5730.member_11, _e5730.member_12, _e5730.member_13, _e5730.member_14, _e5730.member_15, _e5730.member_16, _e5730.member_17, _e5730.member_18, _e5730.member_19, _e5730.member_20, _e5730.member_21, _e5730.member_22, _e5730.member_23, _e5730.member_24, _e5730.member_25, _e5730.member_26, _e5730.member_27);
phi_9400_ = type_25(_e5758.member, _e5758.member_1, _e5758.member_2, _e5758.member_3, _e5758.member_4, _e5758.member_5, _e5758.member_6, _e5758.member_7, _e5758.member_8, _e5758.member_9, select(_e5664, _e5695, _e5699), _e5758.member_11, _e5758.member_12, _e5758.member_13, _e5758.member_14, _e5758.member_15, _e5758.member_16, _e5758.member_17, _e5758.member_18, _e5758.member_19, _e5758.member_20, _e5758.member_21, _e5758.member_22, _e5758.member_23, _e5758.member_24, _e5758.member_25, _e5758.member_26, _e5758.member_27);
phi_9401_ = type_25();
} else {
let _e2122 = (_e2100.member.x + (_e2100.member_1.x * _e2100.member_10));
let _e2125 = (_e2100.member.y + (_e2100.member_1.y * _e2100.member_10));
let _e2128 = (_e2100.member.z + (_e2100.member_1.z * _e2100.member_10));
let _e2157 = type_25(vec3<f32>(_e2122, _e2125, _e2128), _e2100.member_1, _e2100.member_2, _e2100.member_3, _e2100.member_4, _e2100.member_5, _e2100.member_6, _e2100.member_7, _e2100.member_8, _e2100.member_9, _e2100.member_10, _e2100.member_11, _e2100.member_12, _e2100.member_13, _e2100.member_14, _e2100.member_15, _e2100.member_16, _e2100.member_17, _e2100.member_18, _e2100.member_19, _e2100.member_20, _e2100.member_21, _e2100.member_22, _e2100.member_23, _e2100.member_24, _e2100.member_25, _e2100.member_26, _e2100.member_27);
let _e2159 = (_e2100.member_9 * 19i);
let _e2161 = select(_e1466, _e2159, (_e2159 < _e1466));
let _e2167 = global_2.member[bitcast<u32>(select(0i, _e2161, (_e2161 > 0i)))];
let _e2168 = (_e2159 + 1i);
let _e2170 = select(_e1466, _e2168, (_e2168 < _e1466));
let _e2176 = global_2.member[bitcast<u32>(select(0i, _e2170, (_e2170 > 0i)))];
let _e2177 = (_e2159 + 2i);
let _e2179 = select(_e1466, _e2177, (_e2177 < _e1466));
let _e2185 = global_2.member[bitcast<u32>(select(0i, _e2179, (_e2179 > 0i)))];
let _e2186 = (_e2159 + 3i);
let _e2188 = select(_e1466, _e2186, (_e2186 < _e1466));
let _e2194 = global_2.member[bitcast<u32>(select(0i, _e2188, (_e2188 > 0i)))];
let _e2195 = (_e2159 + 4i);
let _e2197 = select(_e1466, _e2195, (_e2195 < _e1466));
let _e2203 = global_2.member[bitcast<u32>(select(0i, _e2197, (_e2197 > 0i)))];
let _e2204 = (_e2159 + 5i);
let _e2206 = select(_e1466, _e2204, (_e2204 < _e1466));
let _e2212 = global_2.member[bitcast<u32>(select(0i, _e2206, (_e2206 > 0i)))];
let _e2213 = (_e2194 - _e2167);
let _e2214 = (_e2203 - _e2176);
let _e2215 = (_e2212 - _e2185);
let _e2216 = (_e2159 + 6i);
let _e2218 = select(_e1466, _e2216, (_e2216 < _e1466));
let _e2224 = global_2.member[bitcast<u32>(select(0i, _e2218, (_e2218 > 0i)))];
let _e2225 = (_e2159 + 7i);
let _e2227 = select(_e1466, _e2225, (_e2225 < _e1466));
let _e2233 = global_2.member[bitcast<u32>(select(0i, _e2227, (_e2227 > 0i)))];
let _e2234 = (_e2159 + 8i);
let _e2236 = select(_e1466, _e2234, (_e2234 < _e1466));
let _e2242 = global_2.member[bitcast<u32>(select(0i, _e2236, (_e2236 > 0i)))];
let _e2243 = (_e2224 - _e2167);
let _e2244 = (_e2233 - _e2176);
let _e2245 = (_e2242 - _e2185);
let _e2248 = ((_e2214 * _e2245) - (_e2215 * _e2244));
let _e2251 = ((_e2215 * _e2243) - (_e2213 * _e2245));
let _e2254 = ((_e2213 * _e2244) - (_e2214 * _e2243));
let _e2259 = (((_e2248 * _e2248) + (_e2251 * _e2251)) + (_e2254 * _e2254));
let _e2271 = (1f / select(1e-30f, _e2259, (_e2259 > 1e-30f)));
let _e2272 = (((_e2244 * _e2254) - (_e2245 * _e2251)) * _e2271);
let _e2273 = (((_e2245 * _e2248) - (_e2243 * _e2254)) * _e2271);
let _e2274 = (((_e2243 * _e2251) - (_e2244 * _e2248)) * _e2271);
let _e2284 = (((_e2251 * _e2215) - (_e2254 * _e2214)) * _e2271);
let _e2285 = (((_e2254 * _e2213) - (_e2248 * _e2215)) * _e2271);
let _e2286 = (((_e2248 * _e2214) - (_e2251 * _e2213)) * _e2271);
let _e2287 = (_e2159 + 9i);
let _e2289 = select(_e1466, _e2287, (_e2287 < _e1466));
let _e2295 = global_2.member[bitcast<u32>(select(0i, _e2289, (_e2289 > 0i)))];
let _e2296 = (_e2159 + 10i);
let _e2298 = select(_e1466, _e2296, (_e2296 < _e1466));
let _e2304 = global_2.member[bitcast<u32>(select(0i, _e2298, (_e2298 > 0i)))];
let _e2305 = (_e2159 + 11i);
let _e2307 = select(_e1466, _e2305, (_e2305 < _e1466));
let _e2313 = global_2.member[bitcast<u32>(select(0i, _e2307, (_e2307 > 0i)))];
let _e2314 = (_e2159 + 12i);
let _e2316 = select(_e1466, _e2314, (_e2314 < _e1466));
let _e2322 = global_2.member[bitcast<u32>(select(0i, _e2316, (_e2316 > 0i)))];
let _e2323 = (_e2159 + 13i);
let _e2325 = select(_e1466, _e2323, (_e2323 < _e1466));
let _e2331 = global_2.member[bitcast<u32>(select(0i, _e2325, (_e2325 > 0i)))];
let _e2332 = (_e2159 + 14i);
let _e2334 = select(_e1466, _e2332, (_e2332 < _e1466));
let _e2340 = global_2.member[bitcast<u32>(select(0i, _e2334, (_e2334 > 0i)))];
let _e2341 = (_e2322 - _e2295);
let _e2342 = (_e2331 - _e2304);
let _e2343 = (_e2340 - _e2313);
let _e2344 = (_e2159 + 15i);
let _e2346 = select(_e1466, _e2344, (_e2344 < _e1466));
let _e2352 = global_2.member[bitcast<u32>(select(0i, _e2346, (_e2346 > 0i)))];
let _e2353 = (_e2159 + 16i);
let _e2355 = select(_e1466, _e2353, (_e2353 < _e1466));
let _e2361 = global_2.member[bitcast<u32>(select(0i, _e2355, (_e2355 > 0i)))];
let _e2362 = (_e2159 + 17i);
let _e2364 = select(_e1466, _e2362, (_e2362 < _e1466));
let _e2370 = global_2.member[bitcast<u32>(select(0i, _e2364, (_e2364 > 0i)))];
let _e2371 = (_e2352 - _e2295);
let _e2372 = (_e2361 - _e2304);
let _e2373 = (_e2370 - _e2313);
let _e2374 = (_e2122 - _e2167);
let _e2375 = (_e2125 - _e2176);
let _e2376 = (_e2128 - _e2185);
let _e2381 = (((_e2272 * _e2374) + (_e2273 * _e2375)) + (_e2274 * _e2376));
let _e2392 = (((_e2284 * _e2374) + (_e2285 * _e2375)) + (_e2286 * _e2376));
let _e2396 = ((_e2295 + (_e2341 * _e2381)) + (_e2371 * _e2392));
let _e2397 = ((_e2304 + (_e2342 * _e2381)) + (_e2372 * _e2392));
let _e2398 = ((_e2313 + (_e2343 * _e2381)) + (_e2373 * _e2392));
let _e2403 = (((_e2396 * _e2396) + (_e2397 * _e2397)) + (_e2398 * _e2398));
let _e2406 = sqrt(select(0f, _e2403, (_e2403 > 0f)));
let _e2409 = (1f / select(1e-20f, _e2406, (_e2406 > 1e-20f)));
let _e2412 = sqrt(select(0f, _e2259, (_e2259 > 0f)));
let _e2415 = (1f / select(1e-20f, _e2412, (_e2412 > 1e-20f)));
let _e2416 = (_e2248 * _e2415);
let _e2417 = (_e2251 * _e2415);
let _e2418 = (_e2254 * _e2415);
let _e2419 = (_e2396 * _e2409);
let _e2420 = (_e2397 * _e2409);
let _e2421 = (_e2398 * _e2409);
if _e1496 {
phi_6571_ = 1f;
phi_6572_ = 1f;
} else {
let _e2423 = local_4;
let _e2424 = (_e2423 * 4i);
let _e2426 = select(_e1484, _e2424, (_e2424 < _e1484));
let _e2432 = global_3.member[bitcast<u32>(select(0i, _e2426, (_e2426 > 0i)))];
let _e2435 = local_5;
let _e2436 = (_e2435 * 4i);
let _e2438 = select(_e1484, _e2436, (_e2436 < _e1484));
let _e2444 = global_3.member[bitcast<u32>(select(0i, _e2438, (_e2438 > 0i)))];
let _e2446 = local_6;
phi_6571_ = select(_e2444, 1f, (_e2446 == 16i));
phi_6572_ = select(_e2432, 1f, _e1439);
}
let _e2450 = phi_6571_;
let _e2452 = phi_6572_;
let _e2459 = select(1f, -1f, ((((_e2100.member_1.x * _e2419) + (_e2100.member_1.y * _e2420)) + (_e2100.member_1.z * _e2421)) > 0f));
let _e2460 = (_e2419 * _e2459);
let _e2461 = (_e2420 * _e2459);
let _e2462 = (_e2421 * _e2459);
let _e2468 = -((((_e2100.member_1.x * _e2460) + (_e2100.member_1.y * _e2461)) + (_e2100.member_1.z * _e2462)));
let _e2470 = select(0f, _e2468, (_e2468 > 0f));
let _e2471 = (_e2452 / _e2450);
let _e2476 = (1f - ((_e2471 * _e2471) * (1f - (_e2470 * _e2470))));
let _e2477 = (_e2476 <= 0f);
let _e2485 = ((_e2471 * _e2470) - sqrt(select(0f, _e2476, (_e2476 > 0f))));
let _e2492 = (2f * _e2470);
let _e2496 = (_e2100.member_1.x + (_e2460 * _e2492));
let _e2497 = (_e2100.member_1.y + (_e2461 * _e2492));
let _e2498 = (_e2100.member_1.z + (_e2462 * _e2492));
let _e2499 = select(((_e2100.member_1.x * _e2471) + (_e2460 * _e2485)), _e2496, _e2477);
let _e2500 = select(((_e2100.member_1.y * _e2471) + (_e2461 * _e2485)), _e2497, _e2477);
let _e2501 = select(((_e2100.member_1.z * _e2471) + (_e2462 * _e2485)), _e2498, _e2477);
let _e2506 = (((_e2499 * _e2499) + (_e2500 * _e2500)) + (_e2501 * _e2501));
let _e2509 = sqrt(select(0f, _e2506, (_e2506 > 0f)));
let _e2512 = (1f / select(1e-20f, _e2509, (_e2509 > 1e-20f)));
let _e2520 = (((_e2100.member_1.x * _e2416) + (_e2100.member_1.y * _e2417)) + (_e2100.member_1.z * _e2418));
let _e2547 = !((((((((_e2419 * _e2100.member_1.x) + (_e2420 * _e2100.member_1.y)) + (_e2421 * _e2100.member_1.z)) * _e2520) > 0f) && (((((((_e2499 * _e2512) * _e2416) + ((_e2500 * _e2512) * _e2417)) + ((_e2501 * _e2512) * _e2418)) * select(1f, -1f, _e2477)) * _e2520) > 0f)) && ((-((((_e2496 * _e2416) + (_e2497 * _e2417)) + (_e2498 * _e2418))) * _e2520) > 0f)));
let _e2548 = select(_e2419, _e2416, _e2547);
let _e2549 = select(_e2420, _e2417, _e2547);
let _e2550 = select(_e2421, _e2418, _e2547);
let _e2551 = select(_e2272, 0f, _e2547);
let _e2552 = select(_e2273, 0f, _e2547);
let _e2553 = select(_e2274, 0f, _e2547);
let _e2554 = select(_e2284, 0f, _e2547);
let _e2555 = select(_e2285, 0f, _e2547);
let _e2556 = select(_e2286, 0f, _e2547);
let _e2568 = (_e2100.member_2.x + (_e2100.member_4.x * _e2100.member_10));
let _e2570 = (_e2100.member_2.y + (_e2100.member_4.y * _e2100.member_10));
let _e2572 = (_e2100.member_2.z + (_e2100.member_4.z * _e2100.member_10));
let _e2580 = (_e2100.member_3.x + (_e2100.member_5.x * _e2100.member_10));
let _e2582 = (_e2100.member_3.y + (_e2100.member_5.y * _e2100.member_10));
let _e2584 = (_e2100.member_3.z + (_e2100.member_5.z * _e2100.member_10));
if ((_e2520 * _e2520) > 1e-12f) {
phi_6805_ = (1f / _e2520);
} else {
phi_6805_ = 0f;
}
let _e2589 = phi_6805_;
let _e2595 = ((((_e2568 * _e2416) + (_e2570 * _e2417)) + (_e2572 * _e2418)) * _e2589);
let _e2599 = (_e2568 - (_e2100.member_1.x * _e2595));
let _e2600 = (_e2570 - (_e2100.member_1.y * _e2595));
let _e2601 = (_e2572 - (_e2100.member_1.z * _e2595));
let _e2602 = vec3<f32>(_e2599, _e2600, _e2601);
let _e2608 = ((((_e2580 * _e2416) + (_e2582 * _e2417)) + (_e2584 * _e2418)) * _e2589);
let _e2612 = (_e2580 - (_e2100.member_1.x * _e2608));
let _e2613 = (_e2582 - (_e2100.member_1.y * _e2608));
let _e2614 = (_e2584 - (_e2100.member_1.z * _e2608));
let _e2615 = vec3<f32>(_e2612, _e2613, _e2614);
let _e2643 = type_25(_e2157.member, _e2157.member_1, _e2602, _e2157.member_3, _e2157.member_4, _e2157.member_5, _e2157.member_6, _e2157.member_7, _e2157.member_8, _e2157.member_9, _e2157.member_10, _e2157.member_11, _e2157.member_12, _e2157.member_13, _e2157.member_14, _e2157.member_15, _e2157.member_16, _e2157.member_17, _e2157.member_18, _e2157.member_19, _e2157.member_20, _e2157.member_21, _e2157.member_22, _e2157.member_23, _e2157.member_24, _e2157.member_25, _e2157.member_26, _e2157.member_27);
let _e2671 = type_25(_e2643.member, _e2643.member_1, _e2643.member_2, _e2615, _e2643.member_4, _e2643.member_5, _e2643.member_6, _e2643.member_7, _e2643.member_8, _e2643.member_9, _e2643.member_10, _e2643.member_11, _e2643.member_12, _e2643.member_13, _e2643.member_14, _e2643.member_15, _e2643.member_16, _e2643.member_17, _e2643.member_18, _e2643.member_19, _e2643.member_20, _e2643.member_21, _e2643.member_22, _e2643.member_23, _e2643.member_24, _e2643.member_25, _e2643.member_26, _e2643.member_27);
let _e2699 = type_25(_e2671.member, _e2671.member_1, _e2671.member_2, _e2671.member_3, _e2100.member_4, _e2671.member_5, _e2671.member_6, _e2671.member_7, _e2671.member_8, _e2671.member_9, _e2671.member_10, _e2671.member_11, _e2671.member_12, _e2671.member_13, _e2671.member_14, _e2671.member_15, _e2671.member_16, _e2671.member_17, _e2671.member_18, _e2671.member_19, _e2671.member_20, _e2671.member_21, _e2671.member_22, _e2671.member_23, _e2671.member_24, _e2671.member_25, _e2671.member_26, _e2671.member_27);
let _e2727 = type_25(_e2699.member, _e2699.member_1, _e2699.member_2, _e2699.member_3, _e2699.member_4, _e2100.member_5, _e2699.member_6, _e2699.member_7, _e2699.member_8, _e2699.member_9, _e2699.member_10, _e2699.member_11, _e2699.member_12, _e2699.member_13, _e2699.member_14, _e2699.member_15, _e2699.member_16, _e2699.member_17, _e2699.member_18, _e2699.member_19, _e2699.member_20, _e2699.member_21, _e2699.member_22, _e2699.member_23, _e2699.member_24, _e2699.member_25, _e2699.member_26, _e2699.member_27);
if _e1496 {
let _e3461 = (_e1482 + 1i);
let _e3463 = select(_e1484, _e3461, (_e3461 < _e1484));
let _e3469 = global_3.member[bitcast<u32>(select(0i, _e3463, (_e3463 > 0i)))];
let _e3470 = (_e1482 + 2i);
let _e3472 = select(_e1484, _e3470, (_e3470 < _e1484));
let _e3478 = global_3.member[bitcast<u32>(select(0i, _e3472, (_e3472 > 0i)))];
let _e3479 = (_e1482 + 3i);
let _e3481 = select(_e1484, _e3479, (_e3479 < _e1484));
let _e3487 = global_3.member[bitcast<u32>(select(0i, _e3481, (_e3481 > 0i)))];
let _e3494 = (1f / 3f);
let _e3498 = (_e2100.member_6.x * _e3469);
let _e3501 = (_e2100.member_6.y * _e3478);
let _e3504 = (_e2100.member_6.z * _e3487);
let _e3533 = type_25(_e2727.member, _e2727.member_1, _e2727.member_2, _e2727.member_3, _e2727.member_4, _e2727.member_5, vec3<f32>(_e3498, _e3501, _e3504), _e2727.member_7, _e2727.member_8, _e2727.member_9, _e2727.member_10, _e2727.member_11, _e2727.member_12, _e2727.member_13, _e2727.member_14, _e2727.member_15, _e2727.member_16, _e2727.member_17, _e2727.member_18, _e2727.member_19, _e2727.member_20, _e2727.member_21, _e2727.member_22, _e2727.member_23, _e2727.member_24, _e2727.member_25, _e2727.member_26, _e2727.member_27);
if (bitcast<i32>(countOneBits(bitcast<u32>((_e2100.member_17 & ((1i << bitcast<u32>((_e2100.member_16 & 31i))) - 1i))))) == _e2100.member_20) {
phi_6936_ = ((((_e2100.member_6.x + _e2100.member_6.y) + _e2100.member_6.z) * _e3494) - (((_e3498 + _e3501) + _e3504) * _e3494));
} else {
phi_6936_ = 0f;
}
let _e3551 = phi_6936_;
let _e3581 = type_25(_e3533.member, _e3533.member_1, _e3533.member_2, _e3533.member_3, _e3533.member_4, _e3533.member_5, _e3533.member_6, _e3533.member_7, _e3533.member_8, _e3533.member_9, _e3533.member_10, _e3533.member_11, _e3533.member_12, _e3533.member_13, _e3533.member_14, _e3533.member_15, _e3533.member_16, _e3533.member_17, _e3533.member_18, _e3533.member_19, _e3533.member_20, _e3533.member_21, _e3533.member_22, _e3533.member_23, _e3533.member_24, (_e2100.member_25 + _e3551), _e3533.member_26, _e3533.member_27);
let _e3588 = select(1f, -1f, ((((_e2548 * _e2100.member_1.x) + (_e2549 * _e2100.member_1.y)) + (_e2550 * _e2100.member_1.z)) > 0f));
let _e3589 = (_e2548 * _e3588);
let _e3590 = (_e2549 * _e3588);
let _e3591 = (_e2550 * _e3588);
let _e3592 = (_e2341 * _e3588);
let _e3593 = (_e2342 * _e3588);
let _e3594 = (_e2343 * _e3588);
let _e3595 = (_e2371 * _e3588);
let _e3596 = (_e2372 * _e3588);
let _e3597 = (_e2373 * _e3588);
let _e3602 = (((_e2551 * _e2599) + (_e2552 * _e2600)) + (_e2553 * _e2601));
let _e3610 = (((_e2554 * _e2599) + (_e2555 * _e2600)) + (_e2556 * _e2601));
let _e3617 = (((_e3592 * _e3602) + (_e3595 * _e3610)) * _e2409);
let _e3618 = (((_e3593 * _e3602) + (_e3596 * _e3610)) * _e2409);
let _e3619 = (((_e3594 * _e3602) + (_e3597 * _e3610)) * _e2409);
let _e3624 = (((_e3589 * _e3617) + (_e3590 * _e3618)) + (_e3591 * _e3619));
let _e3628 = (_e3617 - (_e3589 * _e3624));
let _e3629 = (_e3618 - (_e3590 * _e3624));
let _e3630 = (_e3619 - (_e3591 * _e3624));
let _e3635 = (((_e2100.member_1.x * _e3589) + (_e2100.member_1.y * _e3590)) + (_e2100.member_1.z * _e3591));
let _e3636 = -(_e3635);
let _e3648 = -(((((_e2100.member_4.x * _e3589) + (_e2100.member_4.y * _e3590)) + (_e2100.member_4.z * _e3591)) + (((_e2100.member_1.x * _e3628) + (_e2100.member_1.y * _e3629)) + (_e2100.member_1.z * _e3630))));
let _e3667 = (((_e2551 * _e2612) + (_e2552 * _e2613)) + (_e2553 * _e2614));
let _e3675 = (((_e2554 * _e2612) + (_e2555 * _e2613)) + (_e2556 * _e2614));
let _e3682 = (((_e3592 * _e3667) + (_e3595 * _e3675)) * _e2409);
let _e3683 = (((_e3593 * _e3667) + (_e3596 * _e3675)) * _e2409);
let _e3684 = (((_e3594 * _e3667) + (_e3597 * _e3675)) * _e2409);
let _e3689 = (((_e3589 * _e3682) + (_e3590 * _e3683)) + (_e3591 * _e3684));
let _e3693 = (_e3682 - (_e3589 * _e3689));
let _e3694 = (_e3683 - (_e3590 * _e3689));
let _e3695 = (_e3684 - (_e3591 * _e3689));
let _e3707 = -(((((_e2100.member_5.x * _e3589) + (_e2100.member_5.y * _e3590)) + (_e2100.member_5.z * _e3591)) + (((_e2100.member_1.x * _e3693) + (_e2100.member_1.y * _e3694)) + (_e2100.member_1.z * _e3695))));
let _e3749 = type_25(_e3581.member, _e3581.member_1, _e2602, _e3581.member_3, _e3581.member_4, _e3581.member_5, _e3581.member_6, _e3581.member_7, _e3581.member_8, _e3581.member_9, _e3581.member_10, _e3581.member_11, _e3581.member_12, _e3581.member_13, _e3581.member_14, _e3581.member_15, _e3581.member_16, _e3581.member_17, _e3581.member_18, _e3581.member_19, _e3581.member_20, _e3581.member_21, _e3581.member_22, _e3581.member_23, _e3581.member_24, _e3581.member_25, _e3581.member_26, _e3581.member_27);
let _e3777 = type_25(_e3749.member, _e3749.member_1, _e3749.member_2, _e2615, _e3749.member_4, _e3749.member_5, _e3749.member_6, _e3749.member_7, _e3749.member_8, _e3749.member_9, _e3749.member_10, _e3749.member_11, _e3749.member_12, _e3749.member_13, _e3749.member_14, _e3749.member_15, _e3749.member_16, _e3749.member_17, _e3749.member_18, _e3749.member_19, _e3749.member_20, _e3749.member_21, _e3749.member_22, _e3749.member_23, _e3749.member_24, _e3749.member_25, _e3749.member_26, _e3749.member_27);
let _e3805 = type_25(_e3777.member, _e3777.member_1, _e3777.member_2, _e3777.member_3, (_e2100.member_4 + vec3<f32>((((_e3628 * _e3636) + (_e3589 * _e3648)) * 2f), (((_e3629 * _e3636) + (_e3590 * _e3648)) * 2f), (((_e3630 * _e3636) + (_e3591 * _e3648)) * 2f))), _e3777.member_5, _e3777.member_6, _e3777.member_7, _e3777.member_8, _e3777.member_9, _e3777.member_10, _e3777.member_11, _e3777.member_12, _e3777.member_13, _e3777.member_14, _e3777.member_15, _e3777.member_16, _e3777.member_17, _e3777.member_18, _e3777.member_19, _e3777.member_20, _e3777.member_21, _e3777.member_22, _e3777.member_23, _e3777.member_24, _e3777.member_25, _e3777.member_26, _e3777.member_27);
let _e3833 = type_25(_e3805.member, _e3805.member_1, _e3805.member_2, _e3805.member_3, _e3805.member_4, (_e2100.member_5 + vec3<f32>((((_e3693 * _e3636) + (_e3589 * _e3707)) * 2f), (((_e3694 * _e3636) + (_e3590 * _e3707)) * 2f), (((_e3695 * _e3636) + (_e3591 * _e3707)) * 2f))), _e3805.member_6, _e3805.member_7, _e3805.member_8, _e3805.member_9, _e3805.member_10, _e3805.member_11, _e3805.member_12, _e3805.member_13, _e3805.member_14, _e3805.member_15, _e3805.member_16, _e3805.member_17, _e3805.member_18, _e3805.member_19, _e3805.member_20, _e3805.member_21, _e3805.member_22, _e3805.member_23, _e3805.member_24, _e3805.member_25, _e3805.member_26, _e3805.member_27);
let _e3835 = select(1f, -1f, (_e3635 > 0f));
let _e3836 = (_e3589 * _e3835);
let _e3837 = (_e3590 * _e3835);
let _e3838 = (_e3591 * _e3835);
let _e3844 = -((((_e2100.member_1.x * _e3836) + (_e2100.member_1.y * _e3837)) + (_e2100.member_1.z * _e3838)));
let _e3847 = (2f * select(0f, _e3844, (_e3844 > 0f)));
let _e3880 = type_25(_e3833.member, (_e2100.member_1 + vec3<f32>((_e3836 * _e3847), (_e3837 * _e3847), (_e3838 * _e3847))), _e3833.member_2, _e3833.member_3, _e3833.member_4, _e3833.member_5, _e3833.member_6, _e3833.member_7, _e3833.member_8, _e3833.member_9, _e3833.member_10, _e3833.member_11, _e3833.member_12, _e3833.member_13, _e3833.member_14, _e3833.member_15, _e3833.member_16, _e3833.member_17, _e3833.member_18, _e3833.member_19, _e3833.member_20, _e3833.member_21, _e3833.member_22, _e3833.member_23, _e3833.member_24, _e3833.member_25, _e3833.member_26, _e3833.member_27);
phi_7940_ = type_25(_e3880.member, _e3880.member_1, _e3880.member_2, _e3880.member_3, _e3880.member_4, _e3880.member_5, _e3880.member_6, _e3880.member_7, _e3880.member_8, _e3880.member_9, _e3880.member_10, _e3880.member_11, _e3880.member_12, _e3880.member_13, _e3880.member_14, _e3880.member_15, (_e2100.member_16 + 1i), _e3880.member_17, _e3880.member_18, _e3880.member_19, _e3880.member_20, _e3880.member_21, _e3880.member_22, _e3880.member_23, _e3880.member_24, _e3880.member_25, _e3880.member_26, _e3880.member_27);
} else {
let _e2731 = global_5.member.member_12.member_1;
let _e2733 = local_7;
let _e2734 = (_e2733 * 4i);
let _e2736 = select(_e1484, _e2734, (_e2734 < _e1484));
let _e2742 = global_3.member[bitcast<u32>(select(0i, _e2736, (_e2736 > 0i)))];
let _e2743 = select(_e2742, 1f, _e1439);
let _e2745 = local_8;
let _e2746 = (_e2745 * 4i);
let _e2748 = select(_e1484, _e2746, (_e2746 < _e1484));
let _e2754 = global_3.member[bitcast<u32>(select(0i, _e2748, (_e2748 > 0i)))];
let _e2756 = local_9;
let _e2758 = select(_e2754, 1f, (_e2756 == 16i));
let _e2765 = select(1f, -1f, ((((_e2100.member_1.x * _e2548) + (_e2100.member_1.y * _e2549)) + (_e2100.member_1.z * _e2550)) > 0f));
let _e2766 = (_e2548 * _e2765);
let _e2767 = (_e2549 * _e2765);
let _e2768 = (_e2550 * _e2765);
let _e2774 = -((((_e2100.member_1.x * _e2766) + (_e2100.member_1.y * _e2767)) + (_e2100.member_1.z * _e2768)));
let _e2776 = select(0f, _e2774, (_e2774 > 0f));
let _e2777 = (_e2743 / _e2758);
let _e2778 = (_e2777 * _e2777);
let _e2779 = (_e2776 * _e2776);
let _e2782 = (1f - (_e2778 * (1f - _e2779)));
let _e2783 = (_e2782 <= 0f);
let _e2791 = ((_e2777 * _e2776) - sqrt(select(0f, _e2782, (_e2782 > 0f))));
let _e2798 = (2f * _e2776);
let _e2799 = (_e2766 * _e2798);
let _e2800 = (_e2767 * _e2798);
let _e2801 = (_e2768 * _e2798);
let _e2807 = select(((_e2100.member_1.x * _e2777) + (_e2766 * _e2791)), (_e2100.member_1.x + _e2799), _e2783);
let _e2808 = select(((_e2100.member_1.y * _e2777) + (_e2767 * _e2791)), (_e2100.member_1.y + _e2800), _e2783);
let _e2809 = select(((_e2100.member_1.z * _e2777) + (_e2768 * _e2791)), (_e2100.member_1.z + _e2801), _e2783);
let _e2814 = (((_e2807 * _e2807) + (_e2808 * _e2808)) + (_e2809 * _e2809));
let _e2817 = sqrt(select(0f, _e2814, (_e2814 > 0f)));
let _e2820 = (1f / select(1e-20f, _e2817, (_e2817 > 1e-20f)));
let _e2825 = (_e2758 / _e2743);
let _e2828 = (((_e2825 * _e2825) - 1f) + _e2779);
let _e2831 = sqrt(select(0f, _e2828, (_e2828 > 0f)));
let _e2832 = (_e2831 - _e2776);
let _e2833 = (_e2831 + _e2776);
let _e2836 = (_e2832 / select(1e-6f, _e2833, (_e2833 > 1e-6f)));
let _e2840 = ((_e2776 * _e2832) + 1f);
let _e2843 = (((_e2776 * _e2833) - 1f) / select(1e-6f, _e2840, (_e2840 > 1e-6f)));
let _e2852 = select(select((((0.5f * _e2836) * _e2836) * (1f + (_e2843 * _e2843))), 1f, (_e2828 <= 0f)), 0f, (_e2743 == _e2758));
let _e2855 = (1f - _e2852);
let _e2857 = select(_e2855, _e2852, (_e2852 < _e2855));
let _e2861 = (_e2100.member_16 & 31i);
if (!(_e2783) && (_e2100.member_16 >= _e2100.member_19)) {
let _e2874 = select(_e2100.member_6.y, _e2100.member_6.x, (_e2100.member_6.x > _e2100.member_6.y));
let _e2879 = ((select(_e2100.member_6.z, _e2874, (_e2874 > _e2100.member_6.z)) * _e2857) >= _e2731);
let _e2881 = (1i << bitcast<u32>(_e2861));
if (bitcast<i32>(countOneBits(bitcast<u32>((_e2100.member_17 & (_e2881 - 1i))))) == _e2100.member_20) {
if _e2879 {
phi_7609_ = type_25(_e2727.member, _e2727.member_1, _e2727.member_2, _e2727.member_3, _e2727.member_4, _e2727.member_5, _e2727.member_6, _e2727.member_7, _e2727.member_8, _e2727.member_9, _e2727.member_10, _e2727.member_11, _e2727.member_12, _e2727.member_13, _e2727.member_14, _e2727.member_15, _e2727.member_16, _e2727.member_17, _e2727.member_18, _e2727.member_19, _e2727.member_20, 1i, _e2727.member_22, _e2727.member_23, _e2727.member_24, _e2727.member_25, _e2727.member_26, _e2727.member_27);
} else {
phi_7609_ = type_25(_e2727.member, _e2727.member_1, _e2727.member_2, _e2727.member_3, _e2727.member_4, _e2727.member_5, _e2727.member_6, _e2727.member_7, _e2727.member_8, _e2727.member_9, _e2727.member_10, _e2727.member_11, _e2727.member_12, _e2727.member_13, _e2727.member_14, _e2727.member_15, _e2727.member_16, _e2727.member_17, _e2727.member_18, _e2727.member_19, _e2727.member_20, _e2727.member_21, _e2727.member_22, _e2727.member_23, _e2727.member_24, _e2727.member_25, _e2727.member_26, (_e2100.member_27 + ((((_e2100.member_6.x + _e2100.member_6.y) + _e2100.member_6.z) * (1f / 3f)) * _e2857)));
}
let _e2984 = phi_7609_;
phi_7619_ = _e2984;
} else {
phi_7619_ = type_25(_e2727.member, _e2727.member_1, _e2727.member_2, _e2727.member_3, _e2727.member_4, _e2727.member_5, _e2727.member_6, _e2727.member_7, _e2727.member_8, _e2727.member_9, _e2727.member_10, _e2727.member_11, _e2727.member_12, _e2727.member_13, _e2727.member_14, _e2727.member_15, _e2727.member_16, _e2727.member_17, (_e2100.member_18 | select(0i, _e2881, _e2879)), _e2727.member_19, _e2727.member_20, _e2727.member_21, _e2727.member_22, _e2727.member_23, _e2727.member_24, _e2727.member_25, _e2727.member_26, _e2727.member_27);
}
let _e2986 = phi_7619_;
phi_7620_ = _e2986;
} else {
phi_7620_ = _e2727;
}
let _e2988 = phi_7620_;
let _e2989 = (((_e2100.member_16 < _e2100.member_19) && (((_e2100.member_17 >> bitcast<u32>(_e2861)) & 1i) == 1i)) != (_e2852 > 0.5f));
let _e2990 = (_e2783 || _e2989);
if _e2783 {
phi_7640_ = _e2988;
} else {
let _e2991 = select(_e2855, _e2852, _e2989);
phi_7640_ = type_25(_e2988.member, _e2988.member_1, _e2988.member_2, _e2988.member_3, _e2988.member_4, _e2988.member_5, vec3<f32>((_e2988.member_6.x * _e2991), (_e2988.member_6.y * _e2991), (_e2988.member_6.z * _e2991)), _e2988.member_7, _e2988.member_8, _e2988.member_9, _e2988.member_10, _e2988.member_11, _e2988.member_12, _e2988.member_13, _e2988.member_14, _e2988.member_15, _e2988.member_16, _e2988.member_17, _e2988.member_18, _e2988.member_19, _e2988.member_20, _e2988.member_21, _e2988.member_22, _e2988.member_23, _e2988.member_24, _e2988.member_25, _e2988.member_26, _e2988.member_27);
}
let _e3031 = phi_7640_;
let _e3042 = select(1f, -1f, ((((_e2548 * _e3031.member_1.x) + (_e2549 * _e3031.member_1.y)) + (_e2550 * _e3031.member_1.z)) > 0f));
let _e3043 = (_e2548 * _e3042);
let _e3044 = (_e2549 * _e3042);
let _e3045 = (_e2550 * _e3042);
let _e3046 = (_e2341 * _e3042);
let _e3047 = (_e2342 * _e3042);
let _e3048 = (_e2343 * _e3042);
let _e3049 = (_e2371 * _e3042);
let _e3050 = (_e2372 * _e3042);
let _e3051 = (_e2373 * _e3042);
let _e3063 = (((_e2551 * _e3031.member_2.x) + (_e2552 * _e3031.member_2.y)) + (_e2553 * _e3031.member_2.z));
let _e3071 = (((_e2554 * _e3031.member_2.x) + (_e2555 * _e3031.member_2.y)) + (_e2556 * _e3031.member_2.z));
let _e3078 = (((_e3046 * _e3063) + (_e3049 * _e3071)) * _e2409);
let _e3079 = (((_e3047 * _e3063) + (_e3050 * _e3071)) * _e2409);
let _e3080 = (((_e3048 * _e3063) + (_e3051 * _e3071)) * _e2409);
let _e3085 = (((_e3043 * _e3078) + (_e3044 * _e3079)) + (_e3045 * _e3080));
let _e3089 = (_e3078 - (_e3043 * _e3085));
let _e3090 = (_e3079 - (_e3044 * _e3085));
let _e3091 = (_e3080 - (_e3045 * _e3085));
let _e3097 = -((((_e3031.member_1.x * _e3043) + (_e3031.member_1.y * _e3044)) + (_e3031.member_1.z * _e3045)));
let _e3112 = -(((((_e3031.member_4.x * _e3043) + (_e3031.member_4.y * _e3044)) + (_e3031.member_4.z * _e3045)) + (((_e3031.member_1.x * _e3089) + (_e3031.member_1.y * _e3090)) + (_e3031.member_1.z * _e3091))));
if _e2990 {
phi_7795_ = (_e3031.member_4 + vec3<f32>((((_e3089 * _e3097) + (_e3043 * _e3112)) * 2f), (((_e3090 * _e3097) + (_e3044 * _e3112)) * 2f), (((_e3091 * _e3097) + (_e3045 * _e3112)) * 2f)));
} else {
let _e3116 = (1f - (_e2778 * (1f - (_e3097 * _e3097))));
let _e3118 = select(1e-12f, _e3116, (_e3116 > 1e-12f));
let _e3121 = sqrt(select(0f, _e3118, (_e3118 > 0f)));
let _e3123 = ((_e2777 * _e3097) - _e3121);
let _e3127 = ((_e2777 - ((_e2778 * _e3097) / _e3121)) * _e3112);
phi_7795_ = vec3<f32>((((_e3031.member_4.x * _e2777) + (_e3089 * _e3123)) + (_e3043 * _e3127)), (((_e3031.member_4.y * _e2777) + (_e3090 * _e3123)) + (_e3044 * _e3127)), (((_e3031.member_4.z * _e2777) + (_e3091 * _e3123)) + (_e3045 * _e3127)));
}
let _e3159 = phi_7795_;
let _e3167 = (((_e2551 * _e3031.member_3.x) + (_e2552 * _e3031.member_3.y)) + (_e2553 * _e3031.member_3.z));
let _e3175 = (((_e2554 * _e3031.member_3.x) + (_e2555 * _e3031.member_3.y)) + (_e2556 * _e3031.member_3.z));
let _e3182 = (((_e3046 * _e3167) + (_e3049 * _e3175)) * _e2409);
let _e3183 = (((_e3047 * _e3167) + (_e3050 * _e3175)) * _e2409);
let _e3184 = (((_e3048 * _e3167) + (_e3051 * _e3175)) * _e2409);
let _e3189 = (((_e3043 * _e3182) + (_e3044 * _e3183)) + (_e3045 * _e3184));
let _e3193 = (_e3182 - (_e3043 * _e3189));
let _e3194 = (_e3183 - (_e3044 * _e3189));
let _e3195 = (_e3184 - (_e3045 * _e3189));
let _e3210 = -(((((_e3031.member_5.x * _e3043) + (_e3031.member_5.y * _e3044)) + (_e3031.member_5.z * _e3045)) + (((_e3031.member_1.x * _e3193) + (_e3031.member_1.y * _e3194)) + (_e3031.member_1.z * _e3195))));
if _e2990 {
phi_7921_ = (_e3031.member_5 + vec3<f32>((((_e3193 * _e3097) + (_e3043 * _e3210)) * 2f), (((_e3194 * _e3097) + (_e3044 * _e3210)) * 2f), (((_e3195 * _e3097) + (_e3045 * _e3210)) * 2f)));
} else {
let _e3214 = (1f - (_e2778 * (1f - (_e3097 * _e3097))));
let _e3216 = select(1e-12f, _e3214, (_e3214 > 1e-12f));
let _e3219 = sqrt(select(0f, _e3216, (_e3216 > 0f)));
let _e3221 = ((_e2777 * _e3097) - _e3219);
let _e3225 = ((_e2777 - ((_e2778 * _e3097) / _e3219)) * _e3210);
phi_7921_ = vec3<f32>((((_e3031.member_5.x * _e2777) + (_e3193 * _e3221)) + (_e3043 * _e3225)), (((_e3031.member_5.y * _e2777) + (_e3194 * _e3221)) + (_e3044 * _e3225)), (((_e3031.member_5.z * _e2777) + (_e3195 * _e3221)) + (_e3045 * _e3225)));
}
let _e3257 = phi_7921_;
let _e3285 = type_25(_e3031.member, _e3031.member_1, _e3031.member_2, _e3031.member_3, _e3031.member_4, _e3031.member_5, _e3031.member_6, _e3031.member_7, _e3031.member_8, _e3031.member_9, _e3031.member_10, _e3031.member_11, _e3031.member_12, _e3031.member_13, _e3031.member_14, _e3031.member_15, _e3031.member_16, _e3031.member_17, _e3031.member_18, _e3031.member_19, _e3031.member_20, _e3031.member_21, _e3031.member_22, _e3031.member_23, _e3031.member_24, _e3031.member_25, _e3031.member_26, _e3031.member_27);
let _e3313 = type_25(_e3285.member, _e3285.member_1, _e3285.member_2, _e3031.member_3, _e3285.member_4, _e3285.member_5, _e3285.member_6, _e3285.member_7, _e3285.member_8, _e3285.member_9, _e3285.member_10, _e3285.member_11, _e3285.member_12, _e3285.member_13, _e3285.member_14, _e3285.member_15, _e3285.member_16, _e3285.member_17, _e3285.member_18, _e3285.member_19, _e3285.member_20, _e3285.member_21, _e3285.member_22, _e3285.member_23, _e3285.member_24, _e3285.member_25, _e3285.member_26, _e3285.member_27);
let _e3341 = type_25(_e3313.member, _e3313.member_1, _e3313.member_2, _e3313.member_3, _e3159, _e3313.member_5, _e3313.member_6, _e3313.member_7, _e3313.member_8, _e3313.member_9, _e3313.member_10, _e3313.member_11, _e3313.member_12, _e3313.member_13, _e3313.member_14, _e3313.member_15, _e3313.member_16, _e3313.member_17, _e3313.member_18, _e3313.member_19, _e3313.member_20, _e3313.member_21, _e3313.member_22, _e3313.member_23, _e3313.member_24, _e3313.member_25, _e3313.member_26, _e3313.member_27);
let _e3369 = type_25(_e3341.member, _e3341.member_1, _e3341.member_2, _e3341.member_3, _e3341.member_4, _e3257, _e3341.member_6, _e3341.member_7, _e3341.member_8, _e3341.member_9, _e3341.member_10, _e3341.member_11, _e3341.member_12, _e3341.member_13, _e3341.member_14, _e3341.member_15, _e3341.member_16, _e3341.member_17, _e3341.member_18, _e3341.member_19, _e3341.member_20, _e3341.member_21, _e3341.member_22, _e3341.member_23, _e3341.member_24, _e3341.member_25, _e3341.member_26, _e3341.member_27);
let _e3399 = type_25(_e3369.member, select(vec3<f32>((_e2807 * _e2820), (_e2808 * _e2820), (_e2809 * _e2820)), (_e2100.member_1 + vec3<f32>(_e2799, _e2800, _e2801)), vec3(_e2990)), _e3369.member_2, _e3369.member_3, _e3369.member_4, _e3369.member_5, _e3369.member_6, _e3369.member_7, _e3369.member_8, _e3369.member_9, _e3369.member_10, _e3369.member_11, _e3369.member_12, _e3369.member_13, _e3369.member_14, _e3369.member_15, _e3369.member_16, _e3369.member_17, _e3369.member_18, _e3369.member_19, _e3369.member_20, _e3369.member_21, _e3369.member_22, _e3369.member_23, _e3369.member_24, _e3369.member_25, _e3369.member_26, _e3369.member_27);
let _e3429 = type_25(_e3399.member, _e3399.member_1, _e3399.member_2, _e3399.member_3, _e3399.member_4, _e3399.member_5, _e3399.member_6, _e3399.member_7, _e3399.member_8, _e3399.member_9, _e3399.member_10, _e3399.member_11, _e3399.member_12, _e3399.member_13, _e3399.member_14, _e3399.member_15, (_e3031.member_16 + 1i), _e3399.member_17, _e3399.member_18, _e3399.member_19, _e3399.member_20, _e3399.member_21, _e3399.member_22, _e3399.member_23, _e3399.member_24, _e3399.member_25, _e3399.member_26, _e3399.member_27);
if !(_e2990) {
phi_7939_ = type_25(_e3429.member, _e3429.member_1, _e3429.member_2, _e3429.member_3, _e3429.member_4, _e3429.member_5, _e3429.member_6, _e1505, _e3429.member_8, _e3429.member_9, _e3429.member_10, _e3429.member_11, _e3429.member_12, _e3429.member_13, _e3429.member_14, _e3429.member_15, _e3429.member_16, _e3429.member_17, _e3429.member_18, _e3429.member_19, _e3429.member_20, _e3429.member_21, _e3429.member_22, _e3429.member_23, _e3429.member_24, _e3429.member_25, _e3429.member_26, _e3429.member_27);
} else {
phi_7939_ = _e3429;
}
let _e3460 = phi_7939_;
phi_7940_ = _e3460;
}
let _e3911 = phi_7940_;
let _e3939 = type_25(_e3911.member, _e3911.member_1, _e3911.member_2, _e3911.member_3, _e3911.member_4, _e3911.member_5, _e3911.member_6, _e3911.member_7, _e3911.member_8, _e3911.member_9, _e3911.member_10, _e3911.member_11, _e3911.member_12, 0f, _e3911.member_14, _e3911.member_15, _e3911.member_16, _e3911.member_17, _e3911.member_18, _e3911.member_19, _e3911.member_20, _e3911.member_21, _e3911.member_22, _e3911.member_23, _e3911.member_24, _e3911.member_25, _e3911.member_26, _e3911.member_27);
let _e3967 = type_25(_e3939.member, _e3939.member_1, _e3939.member_2, _e3939.member_3, _e3939.member_4, _e3939.member_5, _e3939.member_6, _e3939.member_7, _e3939.member_8, _e3939.member_9, _e3939.member_10, 0i, _e3939.member_12, _e3939.member_13, _e3939.member_14, _e3939.member_15, _e3939.member_16, _e3939.member_17, _e3939.member_18, _e3939.member_19, _e3939.member_20, _e3939.member_21, _e3939.member_22, _e3939.member_23, _e3939.member_24, _e3939.member_25, _e3939.member_26, _e3939.member_27);
let _e3995 = type_25(_e3967.member, _e3967.member_1, _e3967.member_2, _e3967.member_3, _e3967.member_4, _e3967.member_5, _e3967.member_6, _e3967.member_7, _e3967.member_8, _e3967.member_9, _e3967.member_10, _e3967.member_11, 0i, _e3967.member_13, _e3967.member_14, _e3967.member_15, _e3967.member_16, _e3967.member_17, _e3967.member_18, _e3967.member_19, _e3967.member_20, _e3967.member_21, _e3967.member_22, _e3967.member_23, _e3967.member_24, _e3967.member_25, _e3967.member_26, _e3967.member_27);
let _e4002 = global_5.member.member_14.member.member;
let _e4016 = ((((_e4002.member.member * _e3911.member.x) + (_e4002.member.member_1 * _e3911.member.y)) + (_e4002.member.member_2 * _e3911.member.z)) + _e4002.member_1);
let _e4025 = -((((_e4002.member.member * _e3911.member_1.x) + (_e4002.member.member_1 * _e3911.member_1.y)) + (_e4002.member.member_2 * _e3911.member_1.z)));
let _e4027 = (_e4025 > 1e-9f);
let _e4031 = ((_e4016 / select(1e-9f, _e4025, _e4027)) - 0.015625f);
let _e4034 = select(1e30f, select(0f, _e4031, (_e4031 > 0f)), ((_e4016 > 0f) && _e4027));
let _e4039 = global_5.member.member_14.member_1.member;
let _e4050 = ((((_e4039.member.member * _e3911.member.x) + (_e4039.member.member_1 * _e3911.member.y)) + (_e4039.member.member_2 * _e3911.member.z)) + _e4039.member_1);
let _e4056 = -((((_e4039.member.member * _e3911.member_1.x) + (_e4039.member.member_1 * _e3911.member_1.y)) + (_e4039.member.member_2 * _e3911.member_1.z)));
let _e4058 = (_e4056 > 1e-9f);
let _e4062 = ((_e4050 / select(1e-9f, _e4056, _e4058)) - 0.015625f);
let _e4065 = select(1e30f, select(0f, _e4062, (_e4062 > 0f)), ((_e4050 > 0f) && _e4058));
let _e4069 = (_e4065 < _e4034);
let _e4100 = type_25(_e3995.member, _e3995.member_1, _e3995.member_2, _e3995.member_3, _e3995.member_4, _e3995.member_5, _e3995.member_6, _e3995.member_7, 0i, _e3995.member_9, _e3995.member_10, _e3995.member_11, _e3995.member_12, _e3995.member_13, _e3995.member_14, _e3995.member_15, _e3995.member_16, _e3995.member_17, _e3995.member_18, _e3995.member_19, _e3995.member_20, _e3995.member_21, _e3995.member_22, _e3995.member_23, _e3995.member_24, _e3995.member_25, _e3995.member_26, _e3995.member_27);
let _e4128 = type_25(_e4100.member, _e4100.member_1, _e4100.member_2, _e4100.member_3, _e4100.member_4, _e4100.member_5, _e4100.member_6, _e4100.member_7, _e4100.member_8, select(select(-2i, -3i, _e4069), -1i, ((_e4034 >= 1e30f) && (_e4065 >= 1e30f))), _e4100.member_10, _e4100.member_11, _e4100.member_12, _e4100.member_13, _e4100.member_14, _e4100.member_15, _e4100.member_16, _e4100.member_17, _e4100.member_18, _e4100.member_19, _e4100.member_20, _e4100.member_21, _e4100.member_22, _e4100.member_23, _e4100.member_24, _e4100.member_25, _e4100.member_26, _e4100.member_27);
let _e4156 = type_25(_e4128.member, _e4128.member_1, _e4128.member_2, _e4128.member_3, _e4128.member_4, _e4128.member_5, _e4128.member_6, _e4128.member_7, _e4128.member_8, _e4128.member_9, select(_e4034, _e4065, _e4069), _e4128.member_11, _e4128.member_12, _e4128.member_13, _e4128.member_14, _e4128.member_15, _e4128.member_16, _e4128.member_17, _e4128.member_18, _e4128.member_19, _e4128.member_20, _e4128.member_21, _e4128.member_22, _e4128.member_23, _e4128.member_24, _e4128.member_25, _e4128.member_26, _e4128.member_27);
let _e4161 = global_5.member.member_12.member_3;
if (_e3911.member_16 > bitcast<i32>(_e4161)) {
if (bitcast<i32>(countOneBits(bitcast<u32>((_e3911.member_17 & ((1i << bitcast<u32>((_e3911.member_16 & 31i))) - 1i))))) == _e3911.member_20) {
phi_8095_ = (((_e3911.member_6.x + _e3911.member_6.y) + _e3911.member_6.z) * (1f / 3f));
} else {
phi_8095_ = 0f;
}
let _e4184 = phi_8095_;
let _e4214 = type_25(_e4156.member, _e4156.member_1, _e4156.member_2, _e4156.member_3, _e4156.member_4, _e4156.member_5, _e4156.member_6, _e4156.member_7, _e4156.member_8, _e4156.member_9, _e4156.member_10, _e4156.member_11, _e4156.member_12, _e4156.member_13, _e4156.member_14, _e4156.member_15, _e4156.member_16, _e4156.member_17, _e4156.member_18, _e4156.member_19, _e4156.member_20, _e4156.member_21, _e4156.member_22, _e4156.member_23, _e4156.member_24, _e4156.member_25, _e4156.member_26, (_e3911.member_27 + _e4184));
let _e4216 = (_e3911.member_18 == 0i);
if (_e4216 && (_e3911.member_21 == 0i)) {
phi_9398_ = type_25(_e4214.member, _e4214.member_1, _e4214.member_2, _e4214.member_3, _e4214.member_4, _e4214.member_5, _e4214.member_6, _e4214.member_7, _e4214.member_8, _e4214.member_9, _e4214.member_10, _e4214.member_11, _e4214.member_12, _e4214.member_13, _e4214.member_14, 3f, _e4214.member_16, _e4214.member_17, _e4214.member_18, _e4214.member_19, _e4214.member_20, _e4214.member_21, _e4214.member_22, _e4214.member_23, _e4214.member_24, _e4214.member_25, _e4214.member_26, _e4214.member_27);
} else {
if _e4216 {
let _e4346 = type_25(_e4214.member, _e4214.member_1, _e4214.member_2, _e4214.member_3, _e4214.member_4, _e4214.member_5, _e4214.member_6, _e4214.member_7, _e4214.member_8, _e4214.member_9, _e4214.member_10, _e4214.member_11, _e4214.member_12, _e4214.member_13, _e4214.member_14, _e4214.member_15, _e4214.member_16, _e4214.member_17, _e4214.member_18, _e4214.member_19, (_e3911.member_20 + 1i), _e4214.member_21, _e4214.member_22, _e4214.member_23, _e4214.member_24, _e4214.member_25, _e4214.member_26, _e4214.member_27);
let _e4374 = type_25(_e4346.member, _e4346.member_1, _e4346.member_2, _e4346.member_3, _e4346.member_4, _e4346.member_5, _e4346.member_6, _e4346.member_7, _e4346.member_8, _e4346.member_9, _e4346.member_10, _e4346.member_11, _e4346.member_12, _e4346.member_13, _e4346.member_14, _e4346.member_15, _e4346.member_16, _e4346.member_17, _e4346.member_18, _e4346.member_19, _e4346.member_20, 0i, _e4346.member_22, _e4346.member_23, _e4346.member_24, _e4346.member_25, _e4346.member_26, _e4346.member_27);
let _e4402 = type_25(_e4374.member, _e4374.member_1, _e4374.member_2, _e4374.member_3, _e4374.member_4, _e4374.member_5, _e4374.member_6, _e4374.member_7, _e4374.member_8, _e4374.member_9, _e4374.member_10, _e4374.member_11, _e4374.member_12, _e4374.member_13, _e4374.member_14, _e4374.member_15, _e4374.member_16, 0i, _e4374.member_18, _e4374.member_19, _e4374.member_20, _e4374.member_21, _e4374.member_22, _e4374.member_23, _e4374.member_24, _e4374.member_25, _e4374.member_26, _e4374.member_27);
phi_8139_ = type_25(_e4402.member, _e4402.member_1, _e4402.member_2, _e4402.member_3, _e4402.member_4, _e4402.member_5, _e4402.member_6, _e4402.member_7, _e4402.member_8, _e4402.member_9, _e4402.member_10, _e4402.member_11, _e4402.member_12, _e4402.member_13, _e4402.member_14, _e4402.member_15, _e4402.member_16, _e4402.member_17, _e4402.member_18, 0i, _e4402.member_20, _e4402.member_21, _e4402.member_22, _e4402.member_23, _e4402.member_24, _e4402.member_25, _e4402.member_26, _e4402.member_27);
} else {
let _e4224 = bitcast<i32>((bitcast<u32>(f32(_e3911.member_18)) >> bitcast<u32>(23i)));
let _e4228 = (1i << bitcast<u32>(((_e4224 - 127i) & 31i)));
let _e4229 = (_e4228 - 1i);
let _e4259 = type_25(_e4214.member, _e4214.member_1, _e4214.member_2, _e4214.member_3, _e4214.member_4, _e4214.member_5, _e4214.member_6, _e4214.member_7, _e4214.member_8, _e4214.member_9, _e4214.member_10, _e4214.member_11, _e4214.member_12, _e4214.member_13, _e4214.member_14, _e4214.member_15, _e4214.member_16, ((_e3911.member_17 & _e4229) | _e4228), _e4214.member_18, _e4214.member_19, _e4214.member_20, _e4214.member_21, _e4214.member_22, _e4214.member_23, _e4214.member_24, _e4214.member_25, _e4214.member_26, _e4214.member_27);
let _e4288 = type_25(_e4259.member, _e4259.member_1, _e4259.member_2, _e4259.member_3, _e4259.member_4, _e4259.member_5, _e4259.member_6, _e4259.member_7, _e4259.member_8, _e4259.member_9, _e4259.member_10, _e4259.member_11, _e4259.member_12, _e4259.member_13, _e4259.member_14, _e4259.member_15, _e4259.member_16, _e4259.member_17, (_e3911.member_18 & _e4229), _e4259.member_19, _e4259.member_20, _e4259.member_21, _e4259.member_22, _e4259.member_23, _e4259.member_24, _e4259.member_25, _e4259.member_26, _e4259.member_27);
phi_8139_ = type_25(_e4288.member, _e4288.member_1, _e4288.member_2, _e4288.member_3, _e4288.member_4, _e4288.member_5, _e4288.member_6, _e4288.member_7, _e4288.member_8, _e4288.member_9, _e4288.member_10, _e4288.member_11, _e4288.member_12, _e4288.member_13, _e4288.member_14, _e4288.member_15, _e4288.member_16, _e4288.member_17, _e4288.member_18, (_e4224 + -126i), _e4288.member_20, _e4288.member_21, _e4288.member_22, _e4288.member_23, _e4288.member_24, _e4288.member_25, _e4288.member_26, _e4288.member_27);
}
let _e4432 = phi_8139_;
let _e4438 = global_5.member.member_11.member_2;
let _e4445 = global_5.member.member_11.member_3;
let _e4452 = global_5.member.member_11.member_5;
let _e4458 = global_5.member.member_11.member_7;
let _e4460 = (_e4452 + ((f32(bitcast<i32>(_e120.x)) + 0.5f) * _e4458));
let _e4464 = global_5.member.member_11.member_6;
let _e4470 = global_5.member.member_11.member_8;
let _e4472 = (_e4464 + ((f32(bitcast<i32>(_e120.y)) + 0.5f) * _e4470));
let _e4473 = (_e4438.member * _e4458);
let _e4474 = (_e4438.member_1 * _e4458);
let _e4475 = (_e4438.member_2 * _e4458);
let _e4476 = (_e4445.member * _e4470);
let _e4477 = (_e4445.member_1 * _e4470);
let _e4478 = (_e4445.member_2 * _e4470);
let _e4485 = ((_e4438.member * _e4460) + (_e4445.member * _e4472));
let _e4486 = ((_e4438.member_1 * _e4460) + (_e4445.member_1 * _e4472));
let _e4487 = ((_e4438.member_2 * _e4460) + (_e4445.member_2 * _e4472));
let _e4491 = global_5.member.member_11.member_4;
let _e4498 = global_5.member.member_11.member_1;
let _e4505 = global_5.member.member_10.member;
let _e4506 = (_e4505 == 0u);
let _e4507 = (_e4498.member + _e4485);
let _e4508 = (_e4498.member_1 + _e4486);
let _e4509 = (_e4498.member_2 + _e4487);
let _e4514 = (((_e4507 * _e4507) + (_e4508 * _e4508)) + (_e4509 * _e4509));
let _e4518 = (1f / sqrt(select(0f, _e4514, (_e4514 > 0f))));
let _e4522 = select((_e4507 * _e4518), _e4498.member, _e4506);
let _e4523 = select((_e4508 * _e4518), _e4498.member_1, _e4506);
let _e4524 = select((_e4509 * _e4518), _e4498.member_2, _e4506);
let _e4529 = select(_e4491.member, (_e4491.member + _e4485), _e4506);
let _e4530 = select(_e4491.member_1, (_e4491.member_1 + _e4486), _e4506);
let _e4531 = select(_e4491.member_2, (_e4491.member_2 + _e4487), _e4506);
let _e4545 = (((_e4473 * _e4522) + (_e4474 * _e4523)) + (_e4475 * _e4524));
let _e4555 = select(((_e4473 - (_e4522 * _e4545)) * _e4518), 0f, _e4506);
let _e4556 = select(((_e4474 - (_e4523 * _e4545)) * _e4518), 0f, _e4506);
let _e4557 = select(((_e4475 - (_e4524 * _e4545)) * _e4518), 0f, _e4506);
let _e4563 = (((_e4476 * _e4522) + (_e4477 * _e4523)) + (_e4478 * _e4524));
let _e4573 = select(((_e4476 - (_e4522 * _e4563)) * _e4518), 0f, _e4506);
let _e4574 = select(((_e4477 - (_e4523 * _e4563)) * _e4518), 0f, _e4506);
let _e4575 = select(((_e4478 - (_e4524 * _e4563)) * _e4518), 0f, _e4506);
let _e4584 = (1f / select(_e4522, select(1e-12f, -1e-12f, (_e4522 < 0f)), (bitcast<f32>((bitcast<u32>(_e4522) & 2147483647u)) < 1e-12f)));
let _e4592 = (1f / select(_e4523, select(1e-12f, -1e-12f, (_e4523 < 0f)), (bitcast<f32>((bitcast<u32>(_e4523) & 2147483647u)) < 1e-12f)));
let _e4600 = (1f / select(_e4524, select(1e-12f, -1e-12f, (_e4524 < 0f)), (bitcast<f32>((bitcast<u32>(_e4524) & 2147483647u)) < 1e-12f)));
let _e4603 = global_5.member.member_8;
let _e4609 = global_5.member.member_9;
let _e4614 = ((_e4603.member - _e4529) * _e4584);
let _e4616 = ((_e4609.member - _e4529) * _e4584);
let _e4618 = ((_e4603.member_1 - _e4530) * _e4592);
let _e4620 = ((_e4609.member_1 - _e4530) * _e4592);
let _e4622 = ((_e4603.member_2 - _e4531) * _e4600);
let _e4624 = ((_e4609.member_2 - _e4531) * _e4600);
let _e4626 = select(_e4616, _e4614, (_e4614 < _e4616));
let _e4628 = select(_e4620, _e4618, (_e4618 < _e4620));
let _e4630 = select(_e4628, _e4626, (_e4626 > _e4628));
let _e4632 = select(_e4624, _e4622, (_e4622 < _e4624));
let _e4634 = select(_e4632, _e4630, (_e4630 > _e4632));
let _e4636 = select(_e4616, _e4614, (_e4614 > _e4616));
let _e4638 = select(_e4620, _e4618, (_e4618 > _e4620));
let _e4640 = select(_e4638, _e4636, (_e4636 < _e4638));
let _e4642 = select(_e4624, _e4622, (_e4622 > _e4624));
if (true && _e4506) {
phi_8723_ = -(1e30f);
} else {
phi_8723_ = 0f;
}
let _e4648 = phi_8723_;
let _e4650 = select(_e4648, _e4634, (_e4634 > _e4648));
let _e4652 = ((select(_e4642, _e4640, (_e4640 < _e4642)) <= _e4650) || false);
let _e4653 = select(_e4650, 0f, _e4652);
let _e4654 = (_e4522 * _e4653);
let _e4655 = (_e4523 * _e4653);
let _e4656 = (_e4524 * _e4653);
let _e4657 = (_e4529 + _e4654);
let _e4658 = (_e4530 + _e4655);
let _e4659 = (_e4531 + _e4656);
let _e4689 = type_25((vec3<f32>(_e4529, _e4530, _e4531) + vec3<f32>(_e4654, _e4655, _e4656)), _e4432.member_1, _e4432.member_2, _e4432.member_3, _e4432.member_4, _e4432.member_5, _e4432.member_6, _e4432.member_7, _e4432.member_8, _e4432.member_9, _e4432.member_10, _e4432.member_11, _e4432.member_12, _e4432.member_13, _e4432.member_14, _e4432.member_15, _e4432.member_16, _e4432.member_17, _e4432.member_18, _e4432.member_19, _e4432.member_20, _e4432.member_21, _e4432.member_22, _e4432.member_23, _e4432.member_24, _e4432.member_25, _e4432.member_26, _e4432.member_27);
let _e4717 = type_25(_e4689.member, vec3<f32>(_e4522, _e4523, _e4524), _e4689.member_2, _e4689.member_3, _e4689.member_4, _e4689.member_5, _e4689.member_6, _e4689.member_7, _e4689.member_8, _e4689.member_9, _e4689.member_10, _e4689.member_11, _e4689.member_12, _e4689.member_13, _e4689.member_14, _e4689.member_15, _e4689.member_16, _e4689.member_17, _e4689.member_18, _e4689.member_19, _e4689.member_20, _e4689.member_21, _e4689.member_22, _e4689.member_23, _e4689.member_24, _e4689.member_25, _e4689.member_26, _e4689.member_27);
let _e4755 = type_25(_e4717.member, _e4717.member_1, (vec3<f32>(select(0f, _e4473, _e4506), select(0f, _e4474, _e4506), select(0f, _e4475, _e4506)) + vec3<f32>((_e4555 * _e4653), (_e4556 * _e4653), (_e4557 * _e4653))), _e4717.member_3, _e4717.member_4, _e4717.member_5, _e4717.member_6, _e4717.member_7, _e4717.member_8, _e4717.member_9, _e4717.member_10, _e4717.member_11, _e4717.member_12, _e4717.member_13, _e4717.member_14, _e4717.member_15, _e4717.member_16, _e4717.member_17, _e4717.member_18, _e4717.member_19, _e4717.member_20, _e4717.member_21, _e4717.member_22, _e4717.member_23, _e4717.member_24, _e4717.member_25, _e4717.member_26, _e4717.member_27);
let _e4783 = type_25(_e4755.member, _e4755.member_1, _e4755.member_2, (vec3<f32>(select(0f, _e4476, _e4506), select(0f, _e4477, _e4506), select(0f, _e4478, _e4506)) + vec3<f32>((_e4573 * _e4653), (_e4574 * _e4653), (_e4575 * _e4653))), _e4755.member_4, _e4755.member_5, _e4755.member_6, _e4755.member_7, _e4755.member_8, _e4755.member_9, _e4755.member_10, _e4755.member_11, _e4755.member_12, _e4755.member_13, _e4755.member_14, _e4755.member_15, _e4755.member_16, _e4755.member_17, _e4755.member_18, _e4755.member_19, _e4755.member_20, _e4755.member_21, _e4755.member_22, _e4755.member_23, _e4755.member_24, _e4755.member_25, _e4755.member_26, _e4755.member_27);
let _e4811 = type_25(_e4783.member, _e4783.member_1, _e4783.member_2, _e4783.member_3, vec3<f32>(_e4555, _e4556, _e4557), _e4783.member_5, _e4783.member_6, _e4783.member_7, _e4783.member_8, _e4783.member_9, _e4783.member_10, _e4783.member_11, _e4783.member_12, _e4783.member_13, _e4783.member_14, _e4783.member_15, _e4783.member_16, _e4783.member_17, _e4783.member_18, _e4783.member_19, _e4783.member_20, _e4783.member_21, _e4783.member_22, _e4783.member_23, _e4783.member_24, _e4783.member_25, _e4783.member_26, _e4783.member_27);
let _e4839 = type_25(_e4811.member, _e4811.member_1, _e4811.member_2, _e4811.member_3, _e4811.member_4, vec3<f32>(_e4573, _e4574, _e4575), _e4811.member_6, _e4811.member_7, _e4811.member_8, _e4811.member_9, _e4811.member_10, _e4811.member_11, _e4811.member_12, _e4811.member_13, _e4811.member_14, _e4811.member_15, _e4811.member_16, _e4811.member_17, _e4811.member_18, _e4811.member_19, _e4811.member_20, _e4811.member_21, _e4811.member_22, _e4811.member_23, _e4811.member_24, _e4811.member_25, _e4811.member_26, _e4811.member_27);
let _e4867 = type_25(_e4839.member, _e4839.member_1, _e4839.member_2, _e4839.member_3, _e4839.member_4, _e4839.member_5, _e4839.member_6, 0i, _e4839.member_8, _e4839.member_9, _e4839.member_10, _e4839.member_11, _e4839.member_12, _e4839.member_13, _e4839.member_14, _e4839.member_15, _e4839.member_16, _e4839.member_17, _e4839.member_18, _e4839.member_19, _e4839.member_20, _e4839.member_21, _e4839.member_22, _e4839.member_23, _e4839.member_24, _e4839.member_25, _e4839.member_26, _e4839.member_27);
let _e4895 = type_25(_e4867.member, _e4867.member_1, _e4867.member_2, _e4867.member_3, _e4867.member_4, _e4867.member_5, _e4867.member_6, _e4867.member_7, _e4867.member_8, _e4867.member_9, _e4867.member_10, _e4867.member_11, _e4867.member_12, _e4867.member_13, _e4867.member_14, _e4867.member_15, 0i, _e4867.member_17, _e4867.member_18, _e4867.member_19, _e4867.member_20, _e4867.member_21, _e4867.member_22, _e4867.member_23, _e4867.member_24, _e4867.member_25, _e4867.member_26, _e4867.member_27);
let _e4923 = type_25(_e4895.member, _e4895.member_1, _e4895.member_2, _e4895.member_3, _e4895.member_4, _e4895.member_5, _e4895.member_6, _e4895.member_7, _e4895.member_8, _e4895.member_9, _e4895.member_10, _e4895.member_11, _e4895.member_12, _e4895.member_13, _e4895.member_14, 1f, _e4895.member_16, _e4895.member_17, _e4895.member_18, _e4895.member_19, _e4895.member_20, _e4895.member_21, _e4895.member_22, _e4895.member_23, _e4895.member_24, _e4895.member_25, _e4895.member_26, _e4895.member_27);
let _e4929 = ((((_e4002.member.member * _e4657) + (_e4002.member.member_1 * _e4658)) + (_e4002.member.member_2 * _e4659)) + _e4002.member_1);
let _e4935 = -((((_e4002.member.member * _e4522) + (_e4002.member.member_1 * _e4523)) + (_e4002.member.member_2 * _e4524)));
let _e4937 = (_e4935 > 1e-9f);
let _e4941 = ((_e4929 / select(1e-9f, _e4935, _e4937)) - 0.015625f);
let _e4944 = select(1e30f, select(0f, _e4941, (_e4941 > 0f)), ((_e4929 > 0f) && _e4937));
let _e4950 = ((((_e4039.member.member * _e4657) + (_e4039.member.member_1 * _e4658)) + (_e4039.member.member_2 * _e4659)) + _e4039.member_1);
let _e4956 = -((((_e4039.member.member * _e4522) + (_e4039.member.member_1 * _e4523)) + (_e4039.member.member_2 * _e4524)));
let _e4958 = (_e4956 > 1e-9f);
let _e4962 = ((_e4950 / select(1e-9f, _e4956, _e4958)) - 0.015625f);
let _e4965 = select(1e30f, select(0f, _e4962, (_e4962 > 0f)), ((_e4950 > 0f) && _e4958));
let _e4969 = (_e4965 < _e4944);
let _e5000 = type_25(_e4923.member, _e4923.member_1, _e4923.member_2, _e4923.member_3, _e4923.member_4, _e4923.member_5, _e4923.member_6, _e4923.member_7, 0i, _e4923.member_9, _e4923.member_10, _e4923.member_11, _e4923.member_12, _e4923.member_13, _e4923.member_14, _e4923.member_15, _e4923.member_16, _e4923.member_17, _e4923.member_18, _e4923.member_19, _e4923.member_20, _e4923.member_21, _e4923.member_22, _e4923.member_23, _e4923.member_24, _e4923.member_25, _e4923.member_26, _e4923.member_27);
let _e5028 = type_25(_e5000.member, _e5000.member_1, _e5000.member_2, _e5000.member_3, _e5000.member_4, _e5000.member_5, _e5000.member_6, _e5000.member_7, _e5000.member_8, select(select(-2i, -3i, _e4969), -1i, ((_e4944 >= 1e30f) && (_e4965 >= 1e30f))), _e5000.member_10, _e5000.member_11, _e5000.member_12, _e5000.member_13, _e5000.member_14, _e5000.member_15, _e5000.member_16, _e5000.member_17, _e5000.member_18, _e5000.member_19, _e5000.member_20, _e5000.member_21, _e5000.member_22, _e5000.member_23, _e5000.member_24, _e5000.member_25, _e5000.member_26, _e5000.member_27);
let _e5056 = type_25(_e5028.member, _e5028.member_1, _e5028.member_2, _e5028.member_3, _e5028.member_4, _e5028.member_5, _e5028.member_6, _e5028.member_7, _e5028.member_8, _e5028.member_9, select(_e4944, _e4965, _e4969), _e5028.member_11, _e5028.member_12, _e5028.member_13, _e5028.member_14, _e5028.member_15, _e5028.member_16, _e5028.member_17, _e5028.member_18, _e5028.member_19, _e5028.member_20, _e5028.member_21, _e5028.member_22, _e5028.member_23, _e5028.member_24, _e5028.member_25, _e5028.member_26, _e5028.member_27);
let _e5084 = type_25(_e5056.member, _e5056.member_1, _e5056.member_2, _e5056.member_3, _e5056.member_4, _e5056.member_5, _e5056.member_6, _e5056.member_7, _e5056.member_8, _e5056.member_9, _e5056.member_10, _e5056.member_11, _e5056.member_12, 0f, _e5056.member_14, _e5056.member_15, _e5056.member_16, _e5056.member_17, _e5056.member_18, _e5056.member_19, _e5056.member_20, _e5056.member_21, _e5056.member_22, _e5056.member_23, _e5056.member_24, _e5056.member_25, _e5056.member_26, _e5056.member_27);
let _e5112 = type_25(_e5084.member, _e5084.member_1, _e5084.member_2, _e5084.member_3, _e5084.member_4, _e5084.member_5, _e5084.member_6, _e5084.member_7, _e5084.member_8, _e5084.member_9, _e5084.member_10, 0i, _e5084.member_12, _e5084.member_13, _e5084.member_14, _e5084.member_15, _e5084.member_16, _e5084.member_17, _e5084.member_18, _e5084.member_19, _e5084.member_20, _e5084.member_21, _e5084.member_22, _e5084.member_23, _e5084.member_24, _e5084.member_25, _e5084.member_26, _e5084.member_27);
let _e5140 = type_25(_e5112.member, _e5112.member_1, _e5112.member_2, _e5112.member_3, _e5112.member_4, _e5112.member_5, _e5112.member_6, _e5112.member_7, _e5112.member_8, _e5112.member_9, _e5112.member_10, _e5112.member_11, 0i, _e5112.member_13, _e5112.member_14, _e5112.member_15, _e5112.member_16, _e5112.member_17, _e5112.member_18, _e5112.member_19, _e5112.member_20, _e5112.member_21, _e5112.member_22, _e5112.member_23, _e5112.member_24, _e5112.member_25, _e5112.member_26, _e5112.member_27);
let _e5144 = global_5.member.member_13.member_4;
let _e5151 = global_5.member.member_13.member_5;
let _e5156 = ((_e5144.member - _e4529) * _e4584);
let _e5158 = ((_e5151.member - _e4529) * _e4584);
let _e5160 = ((_e5144.member_1 - _e4530) * _e4592);
let _e5162 = ((_e5151.member_1 - _e4530) * _e4592);
let _e5164 = ((_e5144.member_2 - _e4531) * _e4600);
let _e5166 = ((_e5151.member_2 - _e4531) * _e4600);
let _e5168 = select(_e5158, _e5156, (_e5156 < _e5158));
let _e5170 = select(_e5162, _e5160, (_e5160 < _e5162));
let _e5172 = select(_e5170, _e5168, (_e5168 > _e5170));
let _e5174 = select(_e5166, _e5164, (_e5164 < _e5166));
let _e5176 = select(_e5174, _e5172, (_e5172 > _e5174));
let _e5178 = select(_e5158, _e5156, (_e5156 > _e5158));
let _e5180 = select(_e5162, _e5160, (_e5160 > _e5162));
let _e5182 = select(_e5180, _e5178, (_e5178 < _e5180));
let _e5184 = select(_e5166, _e5164, (_e5164 > _e5166));
let _e5186 = select(_e5184, _e5182, (_e5182 < _e5184));
let _e5188 = select(_e4648, _e5176, (_e5176 > _e4648));
let _e5190 = select(_e4653, _e5186, (_e5186 < _e4653));
let _e5193 = (select(_e5188, _e5190, (_e5190 > _e5188)) - _e5188);
let _e5197 = global_5.member.member_13.member;
let _e5202 = -((_e5197.member * _e5193));
let _e5204 = select(-87f, _e5202, (_e5202 > -87f));
let _e5206 = select(88f, _e5204, (_e5204 < 88f));
let _e5208 = ((_e5206 * 1.442695f) + 0.5f);
let _e5210 = select(-127f, _e5208, (_e5208 > -127f));
let _e5212 = select(128f, _e5210, (_e5210 < 128f));
let _e5219 = select(0i, select(select(i32(_e5212), i32(-2147483648), (_e5212 < -2147483600f)), 2147483647i, (_e5212 > 2147483500f)), (_e5212 == _e5212));
let _e5223 = (_e5219 - select(0i, 1i, (_e5212 < f32(_e5219))));
let _e5224 = f32(_e5223);
let _e5228 = ((_e5206 - (_e5224 * 0.6933594f)) - (_e5224 * -2.1219444e-4f));
let _e5250 = -((_e5197.member_1 * _e5193));
let _e5252 = select(-87f, _e5250, (_e5250 > -87f));
let _e5254 = select(88f, _e5252, (_e5252 < 88f));
let _e5256 = ((_e5254 * 1.442695f) + 0.5f);
let _e5258 = select(-127f, _e5256, (_e5256 > -127f));
let _e5260 = select(128f, _e5258, (_e5258 < 128f));
let _e5267 = select(0i, select(select(i32(_e5260), i32(-2147483648), (_e5260 < -2147483600f)), 2147483647i, (_e5260 > 2147483500f)), (_e5260 == _e5260));
let _e5271 = (_e5267 - select(0i, 1i, (_e5260 < f32(_e5267))));
let _e5272 = f32(_e5271);
let _e5276 = ((_e5254 - (_e5272 * 0.6933594f)) - (_e5272 * -2.1219444e-4f));
let _e5298 = -((_e5197.member_2 * _e5193));
let _e5300 = select(-87f, _e5298, (_e5298 > -87f));
let _e5302 = select(88f, _e5300, (_e5300 < 88f));
let _e5304 = ((_e5302 * 1.442695f) + 0.5f);
let _e5306 = select(-127f, _e5304, (_e5304 > -127f));
let _e5308 = select(128f, _e5306, (_e5306 < 128f));
let _e5315 = select(0i, select(select(i32(_e5308), i32(-2147483648), (_e5308 < -2147483600f)), 2147483647i, (_e5308 > 2147483500f)), (_e5308 == _e5308));
let _e5319 = (_e5315 - select(0i, 1i, (_e5308 < f32(_e5315))));
let _e5320 = f32(_e5319);
let _e5324 = ((_e5302 - (_e5320 * 0.6933594f)) - (_e5320 * -2.1219444e-4f));
let _e5347 = (1f / 3f);
let _e5349 = (1f * ((1f + (_e5228 * (1f + (_e5228 * (0.5f + (_e5228 * (0.16666667f + (_e5228 * (0.041666668f + (_e5228 * (0.008333334f + (_e5228 * (0.001388889f + (_e5228 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5223 + 127i)) << bitcast<u32>(23i)))));
let _e5350 = (1f * ((1f + (_e5276 * (1f + (_e5276 * (0.5f + (_e5276 * (0.16666667f + (_e5276 * (0.041666668f + (_e5276 * (0.008333334f + (_e5276 * (0.001388889f + (_e5276 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5271 + 127i)) << bitcast<u32>(23i)))));
let _e5351 = (1f * ((1f + (_e5324 * (1f + (_e5324 * (0.5f + (_e5324 * (0.16666667f + (_e5324 * (0.041666668f + (_e5324 * (0.008333334f + (_e5324 * (0.001388889f + (_e5324 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5319 + 127i)) << bitcast<u32>(23i)))));
let _e5380 = type_25(_e5140.member, _e5140.member_1, _e5140.member_2, _e5140.member_3, _e5140.member_4, _e5140.member_5, vec3<f32>(_e5349, _e5350, _e5351), _e5140.member_7, _e5140.member_8, _e5140.member_9, _e5140.member_10, _e5140.member_11, _e5140.member_12, _e5140.member_13, _e5140.member_14, _e5140.member_15, _e5140.member_16, _e5140.member_17, _e5140.member_18, _e5140.member_19, _e5140.member_20, _e5140.member_21, _e5140.member_22, _e5140.member_23, _e5140.member_24, _e5140.member_25, _e5140.member_26, _e5140.member_27);
if (bitcast<i32>(countOneBits(0u)) == _e4432.member_20) {
phi_9370_ = ((((1f + 1f) + 1f) * _e5347) - (((_e5349 + _e5350) + _e5351) * _e5347));
} else {
phi_9370_ = 0f;
}
let _e5390 = phi_9370_;
let _e5420 = type_25(_e5380.member, _e5380.member_1, _e5380.member_2, _e5380.member_3, _e5380.member_4, _e5380.member_5, _e5380.member_6, _e5380.member_7, _e5380.member_8, _e5380.member_9, _e5380.member_10, _e5380.member_11, _e5380.member_12, _e5380.member_13, _e5380.member_14, _e5380.member_15, _e5380.member_16, _e5380.member_17, _e5380.member_18, _e5380.member_19, _e5380.member_20, _e5380.member_21, _e5380.member_22, _e5380.member_23, _e5380.member_24, _e5380.member_25, (_e4432.member_26 + _e5390), _e5380.member_27);
if _e4652 {
let _e5448 = type_25(_e5420.member, _e5420.member_1, _e5420.member_2, _e5420.member_3, _e5420.member_4, _e5420.member_5, _e5420.member_6, _e5420.member_7, _e1373, _e5420.member_9, _e5420.member_10, _e5420.member_11, _e5420.member_12, _e5420.member_13, _e5420.member_14, _e5420.member_15, _e5420.member_16, _e5420.member_17, _e5420.member_18, _e5420.member_19, _e5420.member_20, _e5420.member_21, _e5420.member_22, _e5420.member_23, _e5420.member_24, _e5420.member_25, _e5420.member_26, _e5420.member_27);
phi_9397_ = type_25(_e5448.member, _e5448.member_1, _e5448.member_2, _e5448.member_3, _e5448.member_4, _e5448.member_5, _e5448.member_6, _e5448.member_7, _e5448.member_8, _e5448.member_9, _e5448.member_10, _e5448.member_11, _e5448.member_12, _e5448.member_13, _e5448.member_14, 3f, _e5448.member_16, _e5448.member_17, _e5448.member_18, _e5448.member_19, _e5448.member_20, _e5448.member_21, _e5448.member_22, _e5448.member_23, _e5448.member_24, _e5448.member_25, _e5448.member_26, _e5448.member_27);
} else {
phi_9397_ = _e5420;
}
let _e5478 = phi_9397_;
phi_9398_ = _e5478;
}
let _e5508 = phi_9398_;
phi_9399_ = _e5508;
} else {
phi_9399_ = _e4156;
}
let _e5510 = phi_9399_;
phi_9400_ = type_25();
phi_9401_ = _e5510;
}
let _e5788 = phi_9400_;
let _e5790 = phi_9401_;
phi_9402_ = _e5788;
phi_9403_ = _e5790;
phi_9404_ = _e2111;
}
let _e7194 = phi_9402_;
let _e7196 = phi_9403_;
let _e7198 = phi_9404_;
if _e7198 {
phi_9408_ = _e7194;
} else {
phi_9408_ = _e7196;
}
let _e7200 = phi_9408_;
phi_9409_ = _e7200;
}
let _e7260 = phi_9409_;
phi_9411_ = _e7260;
phi_9412_ = select(false, _e1411, _e1454);
}
let _e8116 = phi_9411_;
let _e8118 = phi_9412_;
phi_2425_ = _e8116;
phi_2428_ = (_e1409 + 1i);
phi_2430_ = _e8118;
} else {
phi_2425_ = type_25();
phi_2428_ = i32();
phi_2430_ = bool();
}
let _e8120 = phi_2425_;
let _e8122 = phi_2428_;
let _e8124 = phi_2430_;
continue;
continuing {
phi_2424_ = _e8120;
phi_2427_ = _e8122;
phi_2429_ = _e8124;
break if !(_e1415);
}
}
let _e8127 = local_10;
let _e8131 = local_11;
let _e8135 = local_12;
let _e8139 = local_13;
let _e8143 = local_14;
let _e8147 = local_15;
let _e8151 = local_16;
let _e8155 = local_17;
let _e8159 = local_18;
let _e8163 = local_19;
let _e8167 = local_20;
let _e8171 = local_21;
let _e8175 = local_22;
let _e8179 = local_23;
let _e8183 = local_24;
let _e8187 = local_25;
let _e8191 = local_26;
let _e8195 = local_27;
let _e8199 = local_28;
let _e8203 = local_29;
let _e8207 = local_30;
let _e8211 = local_31;
let _e8215 = local_32;
let _e8219 = local_33;
let _e8223 = local_34;
let _e8226 = local_35;
let _e8230 = local_36;
let _e8234 = local_37;
let _e8237 = local_38;
let _e8240 = local_39;
let _e8244 = local_40;
let _e8248 = local_41;
let _e8252 = local_42;
let _e8256 = local_43;
let _e8260 = local_44;
let _e8264 = local_45;
let _e8268 = local_46;
let _e8271 = local_47;
let _e8274 = local_48;
let _e8277 = local_49;
let _e8280 = local_50;
global_4.member[_e142] = _e8127.member.x;
global_4.member[_e154] = _e8131.member.y;
global_4.member[_e165] = _e8135.member.z;
global_4.member[_e176] = _e8139.member_1.x;
global_4.member[_e187] = _e8143.member_1.y;
global_4.member[_e198] = _e8147.member_1.z;
global_4.member[_e209] = _e8151.member_2.x;
global_4.member[_e220] = _e8155.member_2.y;
global_4.member[_e231] = _e8159.member_2.z;
global_4.member[_e242] = _e8163.member_3.x;
global_4.member[_e253] = _e8167.member_3.y;
global_4.member[_e264] = _e8171.member_3.z;
global_4.member[_e275] = _e8175.member_4.x;
global_4.member[_e286] = _e8179.member_4.y;
global_4.member[_e297] = _e8183.member_4.z;
global_4.member[_e308] = _e8187.member_5.x;
global_4.member[_e319] = _e8191.member_5.y;
global_4.member[_e330] = _e8195.member_5.z;
global_4.member[_e341] = _e8199.member_6.x;
global_4.member[_e352] = _e8203.member_6.y;
global_4.member[_e363] = _e8207.member_6.z;
global_4.member[_e374] = f32(_e8211.member_7);
global_4.member[_e385] = f32(_e8215.member_8);
global_4.member[_e396] = f32(_e8219.member_9);
global_4.member[_e407] = _e8223.member_10;
global_4.member[_e418] = f32(_e8226.member_11);
global_4.member[_e429] = f32(_e8230.member_12);
global_4.member[_e440] = _e8234.member_13;
global_4.member[_e451] = _e8237.member_14;
let _e8343 = local_51;
global_4.member[_e462] = _e8343;
global_4.member[_e473] = f32(_e8240.member_16);
global_4.member[_e484] = f32(_e8244.member_17);
global_4.member[_e495] = f32(_e8248.member_18);
global_4.member[_e506] = f32(_e8252.member_19);
global_4.member[_e517] = f32(_e8256.member_20);
global_4.member[_e528] = f32(_e8260.member_21);
global_4.member[_e539] = f32(_e8264.member_22);
global_4.member[_e550] = _e8268.member_23;
global_4.member[_e561] = _e8271.member_24;
global_4.member[_e572] = _e8274.member_25;
global_4.member[_e583] = _e8277.member_26;
global_4.member[_e594] = _e8280.member_27;
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
