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
struct type_12 {
member: type_2,
member_1: u32,
member_2: type_5,
member_3: type_7,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_5,
member_8: f32,
member_9: f32,
}
struct type_13 {
member: type_2,
member_1: u32,
member_2: type_2,
member_3: u32,
member_4: type_2,
member_5: u32,
member_6: type_4,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: type_5,
member_11: f32,
member_12: f32,
member_13: f32,
member_14: type_5,
member_15: type_5,
member_16: type_6,
member_17: type_9,
member_18: type_11,
member_19: type_5,
member_20: type_12,
}
struct type_14 {
member: type_13,
}
struct type_16 {
member: array<f32>,
}
struct type_20 {
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
member_12: i32,
member_13: i32,
member_14: f32,
}
struct type_22 {
member: array<u32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_14;
@group(0) @binding(3)
var<storage> global_2: type_16;
@group(0) @binding(4)
var<storage, read_write> global_3: type_16;
@group(0) @binding(1)
var<storage> global_4: type_22;
@group(0) @binding(2)
var<storage> global_5: type_22;
fn function_() {
var local: i32;
var local_1: vec3<f32>;
var phi_654_: u32;
var phi_867_: i32;
var phi_870_: i32;
var phi_1306_: f32;
var phi_868_: i32;
var phi_871_: i32;
var local_2: i32;
var phi_1314_: type_20;
var phi_1316_: type_20;
var phi_1319_: i32;
var phi_1655_: f32;
var phi_1693_: i32;
var phi_1696_: i32;
var phi_2132_: f32;
var phi_1694_: i32;
var phi_1697_: i32;
var local_3: i32;
var phi_2144_: i32;
var phi_2147_: f32;
var phi_2149_: f32;
var phi_2178_: i32;
var phi_2181_: i32;
var phi_2617_: f32;
var phi_2179_: i32;
var phi_2182_: i32;
var local_4: i32;
var phi_2145_: i32;
var phi_2148_: f32;
var phi_2150_: f32;
var local_5: f32;
var local_6: f32;
var local_7: f32;
var phi_2652_: i32;
var phi_2655_: i32;
var phi_3091_: f32;
var phi_2653_: i32;
var phi_2656_: i32;
var local_8: i32;
var local_9: i32;
var phi_3551_: f32;
var phi_3990_: f32;
var phi_4430_: f32;
var phi_4869_: f32;
var phi_5309_: f32;
var phi_5748_: f32;
var local_10: f32;
var local_11: i32;
var local_12: f32;
var local_13: f32;
var local_14: f32;
var local_15: f32;
var local_16: f32;
var phi_6078_: type_20;
var local_17: i32;
var local_18: i32;
var phi_6289_: type_20;
var phi_6342_: type_20;
var phi_6356_: type_20;
var local_19: i32;
var phi_6800_: type_20;
var phi_6801_: type_20;
var phi_6781_: type_20;
var phi_6802_: type_20;
var local_20: i32;
var phi_6811_: type_20;
var phi_6812_: type_20;
var phi_6813_: bool;
var phi_7392_: type_20;
var local_21: i32;
var phi_7694_: type_20;
var phi_7695_: type_20;
var phi_7696_: type_20;
var phi_7103_: type_20;
var phi_7697_: type_20;
var phi_1317_: type_20;
var phi_1320_: i32;
var local_22: type_20;
var local_23: type_20;
var local_24: type_20;
var local_25: type_20;
var local_26: type_20;
var local_27: type_20;
var local_28: type_20;
var local_29: type_20;
var local_30: type_20;
var local_31: type_20;
var local_32: type_20;
var local_33: type_20;
var local_34: type_20;
var local_35: type_20;
var local_36: type_20;
var local_37: type_20;
var local_38: type_20;
var local_39: type_20;
var local_40: type_20;
var local_41: type_20;
var local_42: type_20;
var local_43: type_20;
var local_44: type_20;
var local_45: type_20;
var local_46: f32;
let _e85 = global;
let _e91 = arrayLength((&global_5.member));
let _e93 = arrayLength((&global_2.member));
let _e98 = global_1.member.member;
if (_e85.x < _e98.member) {
if (_e85.y < _e98.member_1) {
let _e105 = (_e98.member * _e98.member_1);
let _e107 = ((_e85.y * _e98.member) + _e85.x);
let _e108 = bitcast<i32>(_e107);
let _e110 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e112 = select(_e110, _e108, (_e108 < _e110));
let _e118 = global_3.member[bitcast<u32>(select(0i, _e112, (_e112 > 0i)))];
let _e119 = (_e105 + _e107);
let _e120 = bitcast<i32>(_e119);
let _e122 = select(_e110, _e120, (_e120 < _e110));
let _e128 = global_3.member[bitcast<u32>(select(0i, _e122, (_e122 > 0i)))];
let _e130 = ((2u * _e105) + _e107);
let _e131 = bitcast<i32>(_e130);
let _e133 = select(_e110, _e131, (_e131 < _e110));
let _e139 = global_3.member[bitcast<u32>(select(0i, _e133, (_e133 > 0i)))];
let _e141 = ((3u * _e105) + _e107);
let _e142 = bitcast<i32>(_e141);
let _e144 = select(_e110, _e142, (_e142 < _e110));
let _e150 = global_3.member[bitcast<u32>(select(0i, _e144, (_e144 > 0i)))];
let _e152 = ((4u * _e105) + _e107);
let _e153 = bitcast<i32>(_e152);
let _e155 = select(_e110, _e153, (_e153 < _e110));
let _e161 = global_3.member[bitcast<u32>(select(0i, _e155, (_e155 > 0i)))];
let _e163 = ((5u * _e105) + _e107);
let _e164 = bitcast<i32>(_e163);
let _e166 = select(_e110, _e164, (_e164 < _e110));
let _e172 = global_3.member[bitcast<u32>(select(0i, _e166, (_e166 > 0i)))];
let _e174 = ((6u * _e105) + _e107);
let _e175 = bitcast<i32>(_e174);
let _e177 = select(_e110, _e175, (_e175 < _e110));
let _e183 = global_3.member[bitcast<u32>(select(0i, _e177, (_e177 > 0i)))];
let _e185 = ((7u * _e105) + _e107);
let _e186 = bitcast<i32>(_e185);
let _e188 = select(_e110, _e186, (_e186 < _e110));
let _e194 = global_3.member[bitcast<u32>(select(0i, _e188, (_e188 > 0i)))];
let _e196 = ((8u * _e105) + _e107);
let _e197 = bitcast<i32>(_e196);
let _e199 = select(_e110, _e197, (_e197 < _e110));
let _e205 = global_3.member[bitcast<u32>(select(0i, _e199, (_e199 > 0i)))];
let _e207 = ((9u * _e105) + _e107);
let _e208 = bitcast<i32>(_e207);
let _e210 = select(_e110, _e208, (_e208 < _e110));
let _e216 = global_3.member[bitcast<u32>(select(0i, _e210, (_e210 > 0i)))];
let _e218 = ((10u * _e105) + _e107);
let _e219 = bitcast<i32>(_e218);
let _e221 = select(_e110, _e219, (_e219 < _e110));
let _e227 = global_3.member[bitcast<u32>(select(0i, _e221, (_e221 > 0i)))];
let _e229 = ((11u * _e105) + _e107);
let _e230 = bitcast<i32>(_e229);
let _e232 = select(_e110, _e230, (_e230 < _e110));
let _e238 = global_3.member[bitcast<u32>(select(0i, _e232, (_e232 > 0i)))];
let _e240 = ((12u * _e105) + _e107);
let _e241 = bitcast<i32>(_e240);
let _e243 = select(_e110, _e241, (_e241 < _e110));
let _e249 = global_3.member[bitcast<u32>(select(0i, _e243, (_e243 > 0i)))];
let _e251 = ((13u * _e105) + _e107);
let _e252 = bitcast<i32>(_e251);
let _e254 = select(_e110, _e252, (_e252 < _e110));
let _e260 = global_3.member[bitcast<u32>(select(0i, _e254, (_e254 > 0i)))];
let _e262 = ((14u * _e105) + _e107);
let _e263 = bitcast<i32>(_e262);
let _e265 = select(_e110, _e263, (_e263 < _e110));
let _e271 = global_3.member[bitcast<u32>(select(0i, _e265, (_e265 > 0i)))];
let _e273 = ((15u * _e105) + _e107);
let _e274 = bitcast<i32>(_e273);
let _e276 = select(_e110, _e274, (_e274 < _e110));
let _e282 = global_3.member[bitcast<u32>(select(0i, _e276, (_e276 > 0i)))];
let _e284 = ((16u * _e105) + _e107);
let _e285 = bitcast<i32>(_e284);
let _e287 = select(_e110, _e285, (_e285 < _e110));
let _e293 = global_3.member[bitcast<u32>(select(0i, _e287, (_e287 > 0i)))];
let _e295 = ((17u * _e105) + _e107);
let _e296 = bitcast<i32>(_e295);
let _e298 = select(_e110, _e296, (_e296 < _e110));
let _e304 = global_3.member[bitcast<u32>(select(0i, _e298, (_e298 > 0i)))];
let _e306 = ((18u * _e105) + _e107);
let _e307 = bitcast<i32>(_e306);
let _e309 = select(_e110, _e307, (_e307 < _e110));
let _e315 = global_3.member[bitcast<u32>(select(0i, _e309, (_e309 > 0i)))];
let _e317 = ((19u * _e105) + _e107);
let _e318 = bitcast<i32>(_e317);
let _e320 = select(_e110, _e318, (_e318 < _e110));
let _e326 = global_3.member[bitcast<u32>(select(0i, _e320, (_e320 > 0i)))];
let _e328 = ((20u * _e105) + _e107);
let _e329 = bitcast<i32>(_e328);
let _e331 = select(_e110, _e329, (_e329 < _e110));
let _e337 = global_3.member[bitcast<u32>(select(0i, _e331, (_e331 > 0i)))];
let _e339 = ((21u * _e105) + _e107);
let _e340 = bitcast<i32>(_e339);
let _e342 = select(_e110, _e340, (_e340 < _e110));
let _e348 = global_3.member[bitcast<u32>(select(0i, _e342, (_e342 > 0i)))];
let _e350 = ((22u * _e105) + _e107);
let _e351 = bitcast<i32>(_e350);
let _e353 = select(_e110, _e351, (_e351 < _e110));
let _e359 = global_3.member[bitcast<u32>(select(0i, _e353, (_e353 > 0i)))];
let _e361 = ((23u * _e105) + _e107);
let _e362 = bitcast<i32>(_e361);
let _e364 = select(_e110, _e362, (_e362 < _e110));
let _e370 = global_3.member[bitcast<u32>(select(0i, _e364, (_e364 > 0i)))];
let _e372 = ((24u * _e105) + _e107);
let _e373 = bitcast<i32>(_e372);
let _e375 = select(_e110, _e373, (_e373 < _e110));
let _e381 = global_3.member[bitcast<u32>(select(0i, _e375, (_e375 > 0i)))];
let _e382 = (_e293 == 0f);
if _e382 {
phi_654_ = 3u;
} else {
phi_654_ = select(0u, 1u, (_e293 == 4f));
}
let _e386 = phi_654_;
if (_e386 > 1u) {
let _e389 = vec3<f32>(_e118, _e128, _e139);
let _e390 = vec3<f32>(_e150, _e161, _e172);
let _e391 = vec3<f32>(_e183, _e194, _e205);
let _e392 = vec3<f32>(_e216, _e227, _e238);
let _e393 = vec3<f32>(_e249, _e260, _e271);
let _e407 = select(0i, select(select(i32(_e359), i32(-2147483648), (_e359 < -2147483600f)), 2147483647i, (_e359 > 2147483500f)), (_e359 == _e359));
let _e414 = select(0i, select(select(i32(_e370), i32(-2147483648), (_e370 < -2147483600f)), 2147483647i, (_e370 > 2147483500f)), (_e370 == _e370));
let _e418 = global_1.member.member_14;
let _e424 = global_1.member.member_15;
if (_e382 && (_e315 == 0f)) {
let _e432 = global_1.member.member_3;
phi_867_ = (bitcast<i32>(_e432) - 1i);
phi_870_ = 16i;
loop {
let _e436 = phi_867_;
let _e438 = phi_870_;
local_2 = _e438;
let _e439 = (_e436 >= 0i);
if _e439 {
let _e443 = global_1.member.member_2.member;
let _e448 = global_1.member.member_2.member_1;
let _e453 = global_1.member.member_2.member_2;
let _e455 = (_e118 - 0.5f);
let _e456 = (_e128 - 0.5f);
let _e457 = (_e139 - 0.5f);
let _e459 = f32((bitcast<i32>(_e443) - 2i));
let _e461 = select(0f, _e455, (_e455 > 0f));
let _e463 = select(_e459, _e461, (_e461 < _e459));
let _e470 = select(0i, select(select(i32(_e463), i32(-2147483648), (_e463 < -2147483600f)), 2147483647i, (_e463 > 2147483500f)), (_e463 == _e463));
let _e474 = (_e470 - select(0i, 1i, (_e463 < f32(_e470))));
let _e476 = f32((bitcast<i32>(_e448) - 2i));
let _e478 = select(0f, _e456, (_e456 > 0f));
let _e480 = select(_e476, _e478, (_e478 < _e476));
let _e487 = select(0i, select(select(i32(_e480), i32(-2147483648), (_e480 < -2147483600f)), 2147483647i, (_e480 > 2147483500f)), (_e480 == _e480));
let _e491 = (_e487 - select(0i, 1i, (_e480 < f32(_e487))));
let _e493 = f32((bitcast<i32>(_e453) - 2i));
let _e495 = select(0f, _e457, (_e457 > 0f));
let _e497 = select(_e493, _e495, (_e495 < _e493));
let _e504 = select(0i, select(select(i32(_e497), i32(-2147483648), (_e497 < -2147483600f)), 2147483647i, (_e497 > 2147483500f)), (_e497 == _e497));
let _e508 = (_e504 - select(0i, 1i, (_e497 < f32(_e504))));
let _e509 = (_e436 * 4i);
let _e510 = (_e509 + 1i);
let _e512 = (bitcast<i32>(_e91) - 1i);
let _e514 = select(_e512, _e510, (_e510 < _e512));
let _e520 = global_5.member[bitcast<u32>(select(0i, _e514, (_e514 > 0i)))];
let _e521 = (_e509 + 2i);
let _e523 = select(_e512, _e521, (_e521 < _e512));
let _e529 = global_5.member[bitcast<u32>(select(0i, _e523, (_e523 > 0i)))];
let _e530 = (_e509 + 3i);
let _e532 = select(_e512, _e530, (_e530 < _e512));
let _e538 = global_5.member[bitcast<u32>(select(0i, _e532, (_e532 > 0i)))];
let _e541 = (_e474 - bitcast<i32>((_e520 & 65535u)));
let _e546 = bitcast<i32>((_e520 >> bitcast<u32>(16i)));
let _e551 = (_e491 - bitcast<i32>((_e529 & 65535u)));
let _e556 = bitcast<i32>((_e529 >> bitcast<u32>(16i)));
let _e561 = (_e508 - bitcast<i32>((_e538 & 65535u)));
if ((((_e541 >= 0i) && ((_e541 + 1i) < _e546)) && ((_e551 >= 0i) && ((_e551 + 1i) < _e556))) && ((_e561 >= 0i) && ((_e561 + 1i) < bitcast<i32>((_e538 >> bitcast<u32>(16i)))))) {
let _e571 = (_e556 * _e546);
let _e573 = select(_e512, _e509, (_e509 < _e512));
let _e579 = global_5.member[bitcast<u32>(select(0i, _e573, (_e573 > 0i)))];
let _e585 = (((bitcast<i32>(_e579) + (_e561 * _e571)) + (_e551 * _e546)) + _e541);
let _e587 = (_e455 - f32(_e474));
let _e589 = (_e456 - f32(_e491));
let _e592 = (2i * _e585);
let _e594 = (_e592 >> bitcast<u32>(2i));
let _e597 = bitcast<u32>(((_e592 & 3i) * 8i));
let _e599 = select(_e512, _e594, (_e594 < _e512));
let _e605 = global_5.member[bitcast<u32>(select(0i, _e599, (_e599 > 0i)))];
let _e609 = (_e594 + 1i);
let _e611 = select(_e512, _e609, (_e609 < _e512));
let _e617 = global_5.member[bitcast<u32>(select(0i, _e611, (_e611 > 0i)))];
let _e624 = ((_e605 >> bitcast<u32>((_e597 & 31u))) | ((_e617 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e597) & 31u))));
let _e627 = f32(bitcast<i32>((_e624 & 65535u)));
let _e634 = (_e627 + ((f32(bitcast<i32>((_e624 >> bitcast<u32>(16i)))) - _e627) * _e587));
let _e636 = (2i * (_e585 + _e546));
let _e638 = (_e636 >> bitcast<u32>(2i));
let _e641 = bitcast<u32>(((_e636 & 3i) * 8i));
let _e643 = select(_e512, _e638, (_e638 < _e512));
let _e649 = global_5.member[bitcast<u32>(select(0i, _e643, (_e643 > 0i)))];
let _e653 = (_e638 + 1i);
let _e655 = select(_e512, _e653, (_e653 < _e512));
let _e661 = global_5.member[bitcast<u32>(select(0i, _e655, (_e655 > 0i)))];
let _e668 = ((_e649 >> bitcast<u32>((_e641 & 31u))) | ((_e661 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e641) & 31u))));
let _e671 = f32(bitcast<i32>((_e668 & 65535u)));
let _e679 = (_e585 + _e571);
let _e680 = (2i * _e679);
let _e682 = (_e680 >> bitcast<u32>(2i));
let _e685 = bitcast<u32>(((_e680 & 3i) * 8i));
let _e687 = select(_e512, _e682, (_e682 < _e512));
let _e693 = global_5.member[bitcast<u32>(select(0i, _e687, (_e687 > 0i)))];
let _e697 = (_e682 + 1i);
let _e699 = select(_e512, _e697, (_e697 < _e512));
let _e705 = global_5.member[bitcast<u32>(select(0i, _e699, (_e699 > 0i)))];
let _e712 = ((_e693 >> bitcast<u32>((_e685 & 31u))) | ((_e705 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e685) & 31u))));
let _e715 = f32(bitcast<i32>((_e712 & 65535u)));
let _e722 = (_e715 + ((f32(bitcast<i32>((_e712 >> bitcast<u32>(16i)))) - _e715) * _e587));
let _e724 = (2i * (_e679 + _e546));
let _e726 = (_e724 >> bitcast<u32>(2i));
let _e729 = bitcast<u32>(((_e724 & 3i) * 8i));
let _e731 = select(_e512, _e726, (_e726 < _e512));
let _e737 = global_5.member[bitcast<u32>(select(0i, _e731, (_e731 > 0i)))];
let _e741 = (_e726 + 1i);
let _e743 = select(_e512, _e741, (_e741 < _e512));
let _e749 = global_5.member[bitcast<u32>(select(0i, _e743, (_e743 > 0i)))];
let _e756 = ((_e737 >> bitcast<u32>((_e729 & 31u))) | ((_e749 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e729) & 31u))));
let _e759 = f32(bitcast<i32>((_e756 & 65535u)));
let _e769 = (_e634 + (((_e671 + ((f32(bitcast<i32>((_e668 >> bitcast<u32>(16i)))) - _e671) * _e587)) - _e634) * _e589));
phi_1306_ = (_e769 + (((_e722 + (((_e759 + ((f32(bitcast<i32>((_e756 >> bitcast<u32>(16i)))) - _e759) * _e587)) - _e722) * _e589)) - _e769) * (_e457 - f32(_e508))));
} else {
phi_1306_ = 0f;
}
let _e777 = phi_1306_;
phi_868_ = (_e436 - 1i);
phi_871_ = select(_e438, _e436, (_e777 > 32767.5f));
} else {
phi_868_ = i32();
phi_871_ = i32();
}
let _e782 = phi_868_;
let _e784 = phi_871_;
continue;
continuing {
phi_867_ = _e782;
phi_870_ = _e784;
break if !(_e439);
}
}
let _e787 = local_2;
phi_1314_ = type_20(_e389, _e390, _e391, _e392, _e393, _e282, _e293, _e787, _e315, _e326, _e337, _e348, _e407, _e414, _e381);
} else {
phi_1314_ = type_20(_e389, _e390, _e391, _e392, _e393, _e282, _e293, select(0i, select(select(i32(_e304), i32(-2147483648), (_e304 < -2147483600f)), 2147483647i, (_e304 > 2147483500f)), (_e304 == _e304)), _e315, _e326, _e337, _e348, _e407, _e414, _e381);
}
let _e790 = phi_1314_;
phi_1316_ = _e790;
phi_1319_ = 0i;
loop {
let _e792 = phi_1316_;
let _e794 = phi_1319_;
local_22 = _e792;
local_23 = _e792;
local_24 = _e792;
local_25 = _e792;
local_26 = _e792;
local_27 = _e792;
local_28 = _e792;
local_29 = _e792;
local_30 = _e792;
local_31 = _e792;
local_32 = _e792;
local_33 = _e792;
local_34 = _e792;
local_35 = _e792;
local_36 = _e792;
local_37 = _e792;
local_38 = _e792;
local_39 = _e792;
local_40 = _e792;
local_41 = _e792;
local_42 = _e792;
local_43 = _e792;
local_44 = _e792;
local_45 = _e792;
let _e798 = ((_e794 < 256i) && (_e792.member_6 == 0f));
local_46 = _e792.member_6;
if _e798 {
let _e809 = (1f / select(_e792.member_1.x, select(1e-12f, -1e-12f, (_e792.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e792.member_1.x) & 2147483647u)) < 1e-12f)));
let _e818 = (1f / select(_e792.member_1.y, select(1e-12f, -1e-12f, (_e792.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e792.member_1.y) & 2147483647u)) < 1e-12f)));
let _e827 = (1f / select(_e792.member_1.z, select(1e-12f, -1e-12f, (_e792.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e792.member_1.z) & 2147483647u)) < 1e-12f)));
let _e831 = ((_e418.member - _e792.member.x) * _e809);
let _e833 = ((_e424.member - _e792.member.x) * _e809);
let _e836 = ((_e418.member_1 - _e792.member.y) * _e818);
let _e838 = ((_e424.member_1 - _e792.member.y) * _e818);
let _e841 = ((_e418.member_2 - _e792.member.z) * _e827);
let _e843 = ((_e424.member_2 - _e792.member.z) * _e827);
let _e845 = select(_e833, _e831, (_e831 > _e833));
let _e847 = select(_e838, _e836, (_e836 > _e838));
let _e849 = select(_e847, _e845, (_e845 < _e847));
let _e851 = select(_e843, _e841, (_e841 > _e843));
let _e853 = select(_e851, _e849, (_e849 < _e851));
let _e857 = global_1.member.member_4.member;
let _e858 = bitcast<i32>(_e857);
let _e862 = global_1.member.member_4.member_1;
let _e863 = bitcast<i32>(_e862);
let _e867 = global_1.member.member_4.member_2;
let _e870 = ((_e792.member.x - 0.5f) / 4f);
let _e872 = f32((_e858 - 1i));
let _e874 = select(0f, _e870, (_e870 > 0f));
let _e876 = select(_e872, _e874, (_e874 < _e872));
let _e883 = select(0i, select(select(i32(_e876), i32(-2147483648), (_e876 < -2147483600f)), 2147483647i, (_e876 > 2147483500f)), (_e876 == _e876));
let _e887 = (_e883 - select(0i, 1i, (_e876 < f32(_e883))));
let _e889 = ((_e792.member.y - 0.5f) / 4f);
let _e891 = f32((_e863 - 1i));
let _e893 = select(0f, _e889, (_e889 > 0f));
let _e895 = select(_e891, _e893, (_e893 < _e891));
let _e902 = select(0i, select(select(i32(_e895), i32(-2147483648), (_e895 < -2147483600f)), 2147483647i, (_e895 > 2147483500f)), (_e895 == _e895));
let _e906 = (_e902 - select(0i, 1i, (_e895 < f32(_e902))));
let _e908 = ((_e792.member.z - 0.5f) / 4f);
let _e910 = f32((bitcast<i32>(_e867) - 1i));
let _e912 = select(0f, _e908, (_e908 > 0f));
let _e914 = select(_e910, _e912, (_e912 < _e910));
let _e921 = select(0i, select(select(i32(_e914), i32(-2147483648), (_e914 < -2147483600f)), 2147483647i, (_e914 > 2147483500f)), (_e914 == _e914));
let _e925 = (_e921 - select(0i, 1i, (_e914 < f32(_e921))));
let _e929 = ((((_e925 * _e863) + _e906) * _e858) + _e887);
let _e931 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e933 = select(_e931, _e929, (_e929 < _e931));
let _e939 = global_4.member[bitcast<u32>(select(0i, _e933, (_e933 > 0i)))];
let _e940 = bitcast<i32>(_e939);
if (_e940 > 0i) {
let _e970 = ((((f32(((_e887 - _e940) + 1i)) * 4f) + 0.5f) - _e792.member.x) * _e809);
let _e972 = ((((f32((_e887 + _e940)) * 4f) + 0.5f) - _e792.member.x) * _e809);
let _e974 = ((((f32(((_e906 - _e940) + 1i)) * 4f) + 0.5f) - _e792.member.y) * _e818);
let _e976 = ((((f32((_e906 + _e940)) * 4f) + 0.5f) - _e792.member.y) * _e818);
let _e978 = ((((f32(((_e925 - _e940) + 1i)) * 4f) + 0.5f) - _e792.member.z) * _e827);
let _e980 = ((((f32((_e925 + _e940)) * 4f) + 0.5f) - _e792.member.z) * _e827);
let _e982 = select(_e972, _e970, (_e970 > _e972));
let _e984 = select(_e976, _e974, (_e974 > _e976));
let _e986 = select(_e984, _e982, (_e982 < _e984));
let _e988 = select(_e980, _e978, (_e978 > _e980));
let _e990 = select(_e988, _e986, (_e986 < _e988));
phi_1655_ = (select(0f, _e990, (_e990 > 0f)) + 1e-3f);
} else {
phi_1655_ = 0.5f;
}
let _e995 = phi_1655_;
let _e998 = (select(0f, _e853, (_e853 > 0f)) + 1e-3f);
let _e1000 = select(_e998, _e995, (_e995 < _e998));
let _e1002 = (_e792.member_14 <= _e1000);
let _e1003 = select(_e1000, _e792.member_14, _e1002);
let _e1013 = global_1.member.member_3;
let _e1015 = (bitcast<i32>(_e1013) - 1i);
phi_1693_ = _e1015;
phi_1696_ = 16i;
loop {
let _e1017 = phi_1693_;
let _e1019 = phi_1696_;
local_3 = _e1019;
local_21 = _e1019;
let _e1020 = (_e1017 >= 0i);
if _e1020 {
let _e1024 = global_1.member.member_2.member;
let _e1029 = global_1.member.member_2.member_1;
let _e1034 = global_1.member.member_2.member_2;
let _e1036 = ((_e792.member.x + (_e792.member_1.x * _e1003)) - 0.5f);
let _e1037 = ((_e792.member.y + (_e792.member_1.y * _e1003)) - 0.5f);
let _e1038 = ((_e792.member.z + (_e792.member_1.z * _e1003)) - 0.5f);
let _e1040 = f32((bitcast<i32>(_e1024) - 2i));
let _e1042 = select(0f, _e1036, (_e1036 > 0f));
let _e1044 = select(_e1040, _e1042, (_e1042 < _e1040));
let _e1051 = select(0i, select(select(i32(_e1044), i32(-2147483648), (_e1044 < -2147483600f)), 2147483647i, (_e1044 > 2147483500f)), (_e1044 == _e1044));
let _e1055 = (_e1051 - select(0i, 1i, (_e1044 < f32(_e1051))));
let _e1057 = f32((bitcast<i32>(_e1029) - 2i));
let _e1059 = select(0f, _e1037, (_e1037 > 0f));
let _e1061 = select(_e1057, _e1059, (_e1059 < _e1057));
let _e1068 = select(0i, select(select(i32(_e1061), i32(-2147483648), (_e1061 < -2147483600f)), 2147483647i, (_e1061 > 2147483500f)), (_e1061 == _e1061));
let _e1072 = (_e1068 - select(0i, 1i, (_e1061 < f32(_e1068))));
let _e1074 = f32((bitcast<i32>(_e1034) - 2i));
let _e1076 = select(0f, _e1038, (_e1038 > 0f));
let _e1078 = select(_e1074, _e1076, (_e1076 < _e1074));
let _e1085 = select(0i, select(select(i32(_e1078), i32(-2147483648), (_e1078 < -2147483600f)), 2147483647i, (_e1078 > 2147483500f)), (_e1078 == _e1078));
let _e1089 = (_e1085 - select(0i, 1i, (_e1078 < f32(_e1085))));
let _e1090 = (_e1017 * 4i);
let _e1091 = (_e1090 + 1i);
let _e1093 = (bitcast<i32>(_e91) - 1i);
let _e1095 = select(_e1093, _e1091, (_e1091 < _e1093));
let _e1101 = global_5.member[bitcast<u32>(select(0i, _e1095, (_e1095 > 0i)))];
let _e1102 = (_e1090 + 2i);
let _e1104 = select(_e1093, _e1102, (_e1102 < _e1093));
let _e1110 = global_5.member[bitcast<u32>(select(0i, _e1104, (_e1104 > 0i)))];
let _e1111 = (_e1090 + 3i);
let _e1113 = select(_e1093, _e1111, (_e1111 < _e1093));
let _e1119 = global_5.member[bitcast<u32>(select(0i, _e1113, (_e1113 > 0i)))];
let _e1122 = (_e1055 - bitcast<i32>((_e1101 & 65535u)));
let _e1127 = bitcast<i32>((_e1101 >> bitcast<u32>(16i)));
let _e1132 = (_e1072 - bitcast<i32>((_e1110 & 65535u)));
let _e1137 = bitcast<i32>((_e1110 >> bitcast<u32>(16i)));
let _e1142 = (_e1089 - bitcast<i32>((_e1119 & 65535u)));
if ((((_e1122 >= 0i) && ((_e1122 + 1i) < _e1127)) && ((_e1132 >= 0i) && ((_e1132 + 1i) < _e1137))) && ((_e1142 >= 0i) && ((_e1142 + 1i) < bitcast<i32>((_e1119 >> bitcast<u32>(16i)))))) {
let _e1152 = (_e1137 * _e1127);
let _e1154 = select(_e1093, _e1090, (_e1090 < _e1093));
let _e1160 = global_5.member[bitcast<u32>(select(0i, _e1154, (_e1154 > 0i)))];
let _e1166 = (((bitcast<i32>(_e1160) + (_e1142 * _e1152)) + (_e1132 * _e1127)) + _e1122);
let _e1168 = (_e1036 - f32(_e1055));
let _e1170 = (_e1037 - f32(_e1072));
let _e1173 = (2i * _e1166);
let _e1175 = (_e1173 >> bitcast<u32>(2i));
let _e1178 = bitcast<u32>(((_e1173 & 3i) * 8i));
let _e1180 = select(_e1093, _e1175, (_e1175 < _e1093));
let _e1186 = global_5.member[bitcast<u32>(select(0i, _e1180, (_e1180 > 0i)))];
let _e1190 = (_e1175 + 1i);
let _e1192 = select(_e1093, _e1190, (_e1190 < _e1093));
let _e1198 = global_5.member[bitcast<u32>(select(0i, _e1192, (_e1192 > 0i)))];
let _e1205 = ((_e1186 >> bitcast<u32>((_e1178 & 31u))) | ((_e1198 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1178) & 31u))));
let _e1208 = f32(bitcast<i32>((_e1205 & 65535u)));
let _e1215 = (_e1208 + ((f32(bitcast<i32>((_e1205 >> bitcast<u32>(16i)))) - _e1208) * _e1168));
let _e1217 = (2i * (_e1166 + _e1127));
let _e1219 = (_e1217 >> bitcast<u32>(2i));
let _e1222 = bitcast<u32>(((_e1217 & 3i) * 8i));
let _e1224 = select(_e1093, _e1219, (_e1219 < _e1093));
let _e1230 = global_5.member[bitcast<u32>(select(0i, _e1224, (_e1224 > 0i)))];
let _e1234 = (_e1219 + 1i);
let _e1236 = select(_e1093, _e1234, (_e1234 < _e1093));
let _e1242 = global_5.member[bitcast<u32>(select(0i, _e1236, (_e1236 > 0i)))];
let _e1249 = ((_e1230 >> bitcast<u32>((_e1222 & 31u))) | ((_e1242 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1222) & 31u))));
let _e1252 = f32(bitcast<i32>((_e1249 & 65535u)));
let _e1260 = (_e1166 + _e1152);
let _e1261 = (2i * _e1260);
let _e1263 = (_e1261 >> bitcast<u32>(2i));
let _e1266 = bitcast<u32>(((_e1261 & 3i) * 8i));
let _e1268 = select(_e1093, _e1263, (_e1263 < _e1093));
let _e1274 = global_5.member[bitcast<u32>(select(0i, _e1268, (_e1268 > 0i)))];
let _e1278 = (_e1263 + 1i);
let _e1280 = select(_e1093, _e1278, (_e1278 < _e1093));
let _e1286 = global_5.member[bitcast<u32>(select(0i, _e1280, (_e1280 > 0i)))];
let _e1293 = ((_e1274 >> bitcast<u32>((_e1266 & 31u))) | ((_e1286 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1266) & 31u))));
let _e1296 = f32(bitcast<i32>((_e1293 & 65535u)));
let _e1303 = (_e1296 + ((f32(bitcast<i32>((_e1293 >> bitcast<u32>(16i)))) - _e1296) * _e1168));
let _e1305 = (2i * (_e1260 + _e1127));
let _e1307 = (_e1305 >> bitcast<u32>(2i));
let _e1310 = bitcast<u32>(((_e1305 & 3i) * 8i));
let _e1312 = select(_e1093, _e1307, (_e1307 < _e1093));
let _e1318 = global_5.member[bitcast<u32>(select(0i, _e1312, (_e1312 > 0i)))];
let _e1322 = (_e1307 + 1i);
let _e1324 = select(_e1093, _e1322, (_e1322 < _e1093));
let _e1330 = global_5.member[bitcast<u32>(select(0i, _e1324, (_e1324 > 0i)))];
let _e1337 = ((_e1318 >> bitcast<u32>((_e1310 & 31u))) | ((_e1330 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1310) & 31u))));
let _e1340 = f32(bitcast<i32>((_e1337 & 65535u)));
let _e1350 = (_e1215 + (((_e1252 + ((f32(bitcast<i32>((_e1249 >> bitcast<u32>(16i)))) - _e1252) * _e1168)) - _e1215) * _e1170));
phi_2132_ = (_e1350 + (((_e1303 + (((_e1340 + ((f32(bitcast<i32>((_e1337 >> bitcast<u32>(16i)))) - _e1340) * _e1168)) - _e1303) * _e1170)) - _e1350) * (_e1038 - f32(_e1089))));
} else {
phi_2132_ = 0f;
}
let _e1358 = phi_2132_;
phi_1694_ = (_e1017 - 1i);
phi_1697_ = select(_e1019, _e1017, (_e1358 > 32767.5f));
} else {
phi_1694_ = i32();
phi_1697_ = i32();
}
let _e1363 = phi_1694_;
let _e1365 = phi_1697_;
continue;
continuing {
phi_1693_ = _e1363;
phi_1696_ = _e1365;
break if !(_e1020);
}
}
let _e1368 = local_3;
let _e1369 = (_e1368 == _e792.member_7);
if _e1369 {
phi_6812_ = _e792;
phi_6813_ = _e1369;
} else {
phi_2144_ = 0i;
phi_2147_ = 0f;
phi_2149_ = _e1003;
loop {
let _e1371 = phi_2144_;
let _e1373 = phi_2147_;
let _e1375 = phi_2149_;
local_5 = _e1375;
local_6 = _e1375;
local_7 = _e1375;
local_10 = _e1375;
local_12 = _e1375;
local_13 = _e1375;
local_14 = _e1375;
local_15 = _e1375;
local_16 = _e1375;
let _e1376 = (_e1371 < 12i);
if _e1376 {
let _e1378 = (0.5f * (_e1373 + _e1375));
phi_2178_ = _e1015;
phi_2181_ = 16i;
loop {
let _e1386 = phi_2178_;
let _e1388 = phi_2181_;
local_4 = _e1388;
let _e1389 = (_e1386 >= 0i);
if _e1389 {
let _e1393 = global_1.member.member_2.member;
let _e1398 = global_1.member.member_2.member_1;
let _e1403 = global_1.member.member_2.member_2;
let _e1405 = ((_e792.member.x + (_e792.member_1.x * _e1378)) - 0.5f);
let _e1406 = ((_e792.member.y + (_e792.member_1.y * _e1378)) - 0.5f);
let _e1407 = ((_e792.member.z + (_e792.member_1.z * _e1378)) - 0.5f);
let _e1409 = f32((bitcast<i32>(_e1393) - 2i));
let _e1411 = select(0f, _e1405, (_e1405 > 0f));
let _e1413 = select(_e1409, _e1411, (_e1411 < _e1409));
let _e1420 = select(0i, select(select(i32(_e1413), i32(-2147483648), (_e1413 < -2147483600f)), 2147483647i, (_e1413 > 2147483500f)), (_e1413 == _e1413));
let _e1424 = (_e1420 - select(0i, 1i, (_e1413 < f32(_e1420))));
let _e1426 = f32((bitcast<i32>(_e1398) - 2i));
let _e1428 = select(0f, _e1406, (_e1406 > 0f));
let _e1430 = select(_e1426, _e1428, (_e1428 < _e1426));
let _e1437 = select(0i, select(select(i32(_e1430), i32(-2147483648), (_e1430 < -2147483600f)), 2147483647i, (_e1430 > 2147483500f)), (_e1430 == _e1430));
let _e1441 = (_e1437 - select(0i, 1i, (_e1430 < f32(_e1437))));
let _e1443 = f32((bitcast<i32>(_e1403) - 2i));
let _e1445 = select(0f, _e1407, (_e1407 > 0f));
let _e1447 = select(_e1443, _e1445, (_e1445 < _e1443));
let _e1454 = select(0i, select(select(i32(_e1447), i32(-2147483648), (_e1447 < -2147483600f)), 2147483647i, (_e1447 > 2147483500f)), (_e1447 == _e1447));
let _e1458 = (_e1454 - select(0i, 1i, (_e1447 < f32(_e1454))));
let _e1459 = (_e1386 * 4i);
let _e1460 = (_e1459 + 1i);
let _e1462 = (bitcast<i32>(_e91) - 1i);
let _e1464 = select(_e1462, _e1460, (_e1460 < _e1462));
let _e1470 = global_5.member[bitcast<u32>(select(0i, _e1464, (_e1464 > 0i)))];
let _e1471 = (_e1459 + 2i);
let _e1473 = select(_e1462, _e1471, (_e1471 < _e1462));
let _e1479 = global_5.member[bitcast<u32>(select(0i, _e1473, (_e1473 > 0i)))];
let _e1480 = (_e1459 + 3i);
let _e1482 = select(_e1462, _e1480, (_e1480 < _e1462));
let _e1488 = global_5.member[bitcast<u32>(select(0i, _e1482, (_e1482 > 0i)))];
let _e1491 = (_e1424 - bitcast<i32>((_e1470 & 65535u)));
let _e1496 = bitcast<i32>((_e1470 >> bitcast<u32>(16i)));
let _e1501 = (_e1441 - bitcast<i32>((_e1479 & 65535u)));
let _e1506 = bitcast<i32>((_e1479 >> bitcast<u32>(16i)));
let _e1511 = (_e1458 - bitcast<i32>((_e1488 & 65535u)));
if ((((_e1491 >= 0i) && ((_e1491 + 1i) < _e1496)) && ((_e1501 >= 0i) && ((_e1501 + 1i) < _e1506))) && ((_e1511 >= 0i) && ((_e1511 + 1i) < bitcast<i32>((_e1488 >> bitcast<u32>(16i)))))) {
let _e1521 = (_e1506 * _e1496);
let _e1523 = select(_e1462, _e1459, (_e1459 < _e1462));
let _e1529 = global_5.member[bitcast<u32>(select(0i, _e1523, (_e1523 > 0i)))];
let _e1535 = (((bitcast<i32>(_e1529) + (_e1511 * _e1521)) + (_e1501 * _e1496)) + _e1491);
let _e1537 = (_e1405 - f32(_e1424));
let _e1539 = (_e1406 - f32(_e1441));
let _e1542 = (2i * _e1535);
let _e1544 = (_e1542 >> bitcast<u32>(2i));
let _e1547 = bitcast<u32>(((_e1542 & 3i) * 8i));
let _e1549 = select(_e1462, _e1544, (_e1544 < _e1462));
let _e1555 = global_5.member[bitcast<u32>(select(0i, _e1549, (_e1549 > 0i)))];
let _e1559 = (_e1544 + 1i);
let _e1561 = select(_e1462, _e1559, (_e1559 < _e1462));
let _e1567 = global_5.member[bitcast<u32>(select(0i, _e1561, (_e1561 > 0i)))];
let _e1574 = ((_e1555 >> bitcast<u32>((_e1547 & 31u))) | ((_e1567 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1547) & 31u))));
let _e1577 = f32(bitcast<i32>((_e1574 & 65535u)));
let _e1584 = (_e1577 + ((f32(bitcast<i32>((_e1574 >> bitcast<u32>(16i)))) - _e1577) * _e1537));
let _e1586 = (2i * (_e1535 + _e1496));
let _e1588 = (_e1586 >> bitcast<u32>(2i));
let _e1591 = bitcast<u32>(((_e1586 & 3i) * 8i));
let _e1593 = select(_e1462, _e1588, (_e1588 < _e1462));
let _e1599 = global_5.member[bitcast<u32>(select(0i, _e1593, (_e1593 > 0i)))];
let _e1603 = (_e1588 + 1i);
let _e1605 = select(_e1462, _e1603, (_e1603 < _e1462));
let _e1611 = global_5.member[bitcast<u32>(select(0i, _e1605, (_e1605 > 0i)))];
let _e1618 = ((_e1599 >> bitcast<u32>((_e1591 & 31u))) | ((_e1611 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1591) & 31u))));
let _e1621 = f32(bitcast<i32>((_e1618 & 65535u)));
let _e1629 = (_e1535 + _e1521);
let _e1630 = (2i * _e1629);
let _e1632 = (_e1630 >> bitcast<u32>(2i));
let _e1635 = bitcast<u32>(((_e1630 & 3i) * 8i));
let _e1637 = select(_e1462, _e1632, (_e1632 < _e1462));
let _e1643 = global_5.member[bitcast<u32>(select(0i, _e1637, (_e1637 > 0i)))];
let _e1647 = (_e1632 + 1i);
let _e1649 = select(_e1462, _e1647, (_e1647 < _e1462));
let _e1655 = global_5.member[bitcast<u32>(select(0i, _e1649, (_e1649 > 0i)))];
let _e1662 = ((_e1643 >> bitcast<u32>((_e1635 & 31u))) | ((_e1655 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1635) & 31u))));
let _e1665 = f32(bitcast<i32>((_e1662 & 65535u)));
let _e1672 = (_e1665 + ((f32(bitcast<i32>((_e1662 >> bitcast<u32>(16i)))) - _e1665) * _e1537));
let _e1674 = (2i * (_e1629 + _e1496));
let _e1676 = (_e1674 >> bitcast<u32>(2i));
let _e1679 = bitcast<u32>(((_e1674 & 3i) * 8i));
let _e1681 = select(_e1462, _e1676, (_e1676 < _e1462));
let _e1687 = global_5.member[bitcast<u32>(select(0i, _e1681, (_e1681 > 0i)))];
let _e1691 = (_e1676 + 1i);
let _e1693 = select(_e1462, _e1691, (_e1691 < _e1462));
let _e1699 = global_5.member[bitcast<u32>(select(0i, _e1693, (_e1693 > 0i)))];
let _e1706 = ((_e1687 >> bitcast<u32>((_e1679 & 31u))) | ((_e1699 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1679) & 31u))));
let _e1709 = f32(bitcast<i32>((_e1706 & 65535u)));
let _e1719 = (_e1584 + (((_e1621 + ((f32(bitcast<i32>((_e1618 >> bitcast<u32>(16i)))) - _e1621) * _e1537)) - _e1584) * _e1539));
phi_2617_ = (_e1719 + (((_e1672 + (((_e1709 + ((f32(bitcast<i32>((_e1706 >> bitcast<u32>(16i)))) - _e1709) * _e1537)) - _e1672) * _e1539)) - _e1719) * (_e1407 - f32(_e1458))));
} else {
phi_2617_ = 0f;
}
let _e1727 = phi_2617_;
phi_2179_ = (_e1386 - 1i);
phi_2182_ = select(_e1388, _e1386, (_e1727 > 32767.5f));
} else {
phi_2179_ = i32();
phi_2182_ = i32();
}
let _e1732 = phi_2179_;
let _e1734 = phi_2182_;
continue;
continuing {
phi_2178_ = _e1732;
phi_2181_ = _e1734;
break if !(_e1389);
}
}
let _e1737 = local_4;
let _e1738 = (_e1737 == _e792.member_7);
phi_2145_ = (_e1371 + 1i);
phi_2148_ = select(_e1373, _e1378, _e1738);
phi_2150_ = select(_e1378, _e1375, _e1738);
} else {
phi_2145_ = i32();
phi_2148_ = f32();
phi_2150_ = f32();
}
let _e1743 = phi_2145_;
let _e1745 = phi_2148_;
let _e1747 = phi_2150_;
continue;
continuing {
phi_2144_ = _e1743;
phi_2147_ = _e1745;
phi_2149_ = _e1747;
break if !(_e1376);
}
}
let _e1750 = local_5;
let _e1751 = (_e792.member_1.x * _e1750);
let _e1753 = local_6;
let _e1754 = (_e792.member_1.y * _e1753);
let _e1756 = local_7;
let _e1757 = (_e792.member_1.z * _e1756);
phi_2652_ = _e1015;
phi_2655_ = 16i;
loop {
let _e1764 = phi_2652_;
let _e1766 = phi_2655_;
local_8 = _e1766;
local_9 = _e1766;
local_11 = _e1766;
local_17 = _e1766;
local_18 = _e1766;
local_19 = _e1766;
local_20 = _e1766;
let _e1767 = (_e1764 >= 0i);
if _e1767 {
let _e1771 = global_1.member.member_2.member;
let _e1776 = global_1.member.member_2.member_1;
let _e1781 = global_1.member.member_2.member_2;
let _e1783 = ((_e792.member.x + _e1751) - 0.5f);
let _e1784 = ((_e792.member.y + _e1754) - 0.5f);
let _e1785 = ((_e792.member.z + _e1757) - 0.5f);
let _e1787 = f32((bitcast<i32>(_e1771) - 2i));
let _e1789 = select(0f, _e1783, (_e1783 > 0f));
let _e1791 = select(_e1787, _e1789, (_e1789 < _e1787));
let _e1798 = select(0i, select(select(i32(_e1791), i32(-2147483648), (_e1791 < -2147483600f)), 2147483647i, (_e1791 > 2147483500f)), (_e1791 == _e1791));
let _e1802 = (_e1798 - select(0i, 1i, (_e1791 < f32(_e1798))));
let _e1804 = f32((bitcast<i32>(_e1776) - 2i));
let _e1806 = select(0f, _e1784, (_e1784 > 0f));
let _e1808 = select(_e1804, _e1806, (_e1806 < _e1804));
let _e1815 = select(0i, select(select(i32(_e1808), i32(-2147483648), (_e1808 < -2147483600f)), 2147483647i, (_e1808 > 2147483500f)), (_e1808 == _e1808));
let _e1819 = (_e1815 - select(0i, 1i, (_e1808 < f32(_e1815))));
let _e1821 = f32((bitcast<i32>(_e1781) - 2i));
let _e1823 = select(0f, _e1785, (_e1785 > 0f));
let _e1825 = select(_e1821, _e1823, (_e1823 < _e1821));
let _e1832 = select(0i, select(select(i32(_e1825), i32(-2147483648), (_e1825 < -2147483600f)), 2147483647i, (_e1825 > 2147483500f)), (_e1825 == _e1825));
let _e1836 = (_e1832 - select(0i, 1i, (_e1825 < f32(_e1832))));
let _e1837 = (_e1764 * 4i);
let _e1838 = (_e1837 + 1i);
let _e1840 = (bitcast<i32>(_e91) - 1i);
let _e1842 = select(_e1840, _e1838, (_e1838 < _e1840));
let _e1848 = global_5.member[bitcast<u32>(select(0i, _e1842, (_e1842 > 0i)))];
let _e1849 = (_e1837 + 2i);
let _e1851 = select(_e1840, _e1849, (_e1849 < _e1840));
let _e1857 = global_5.member[bitcast<u32>(select(0i, _e1851, (_e1851 > 0i)))];
let _e1858 = (_e1837 + 3i);
let _e1860 = select(_e1840, _e1858, (_e1858 < _e1840));
let _e1866 = global_5.member[bitcast<u32>(select(0i, _e1860, (_e1860 > 0i)))];
let _e1869 = (_e1802 - bitcast<i32>((_e1848 & 65535u)));
let _e1874 = bitcast<i32>((_e1848 >> bitcast<u32>(16i)));
let _e1879 = (_e1819 - bitcast<i32>((_e1857 & 65535u)));
let _e1884 = bitcast<i32>((_e1857 >> bitcast<u32>(16i)));
let _e1889 = (_e1836 - bitcast<i32>((_e1866 & 65535u)));
if ((((_e1869 >= 0i) && ((_e1869 + 1i) < _e1874)) && ((_e1879 >= 0i) && ((_e1879 + 1i) < _e1884))) && ((_e1889 >= 0i) && ((_e1889 + 1i) < bitcast<i32>((_e1866 >> bitcast<u32>(16i)))))) {
let _e1899 = (_e1884 * _e1874);
let _e1901 = select(_e1840, _e1837, (_e1837 < _e1840));
let _e1907 = global_5.member[bitcast<u32>(select(0i, _e1901, (_e1901 > 0i)))];
let _e1913 = (((bitcast<i32>(_e1907) + (_e1889 * _e1899)) + (_e1879 * _e1874)) + _e1869);
let _e1915 = (_e1783 - f32(_e1802));
let _e1917 = (_e1784 - f32(_e1819));
let _e1920 = (2i * _e1913);
let _e1922 = (_e1920 >> bitcast<u32>(2i));
let _e1925 = bitcast<u32>(((_e1920 & 3i) * 8i));
let _e1927 = select(_e1840, _e1922, (_e1922 < _e1840));
let _e1933 = global_5.member[bitcast<u32>(select(0i, _e1927, (_e1927 > 0i)))];
let _e1937 = (_e1922 + 1i);
let _e1939 = select(_e1840, _e1937, (_e1937 < _e1840));
let _e1945 = global_5.member[bitcast<u32>(select(0i, _e1939, (_e1939 > 0i)))];
let _e1952 = ((_e1933 >> bitcast<u32>((_e1925 & 31u))) | ((_e1945 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1925) & 31u))));
let _e1955 = f32(bitcast<i32>((_e1952 & 65535u)));
let _e1962 = (_e1955 + ((f32(bitcast<i32>((_e1952 >> bitcast<u32>(16i)))) - _e1955) * _e1915));
let _e1964 = (2i * (_e1913 + _e1874));
let _e1966 = (_e1964 >> bitcast<u32>(2i));
let _e1969 = bitcast<u32>(((_e1964 & 3i) * 8i));
let _e1971 = select(_e1840, _e1966, (_e1966 < _e1840));
let _e1977 = global_5.member[bitcast<u32>(select(0i, _e1971, (_e1971 > 0i)))];
let _e1981 = (_e1966 + 1i);
let _e1983 = select(_e1840, _e1981, (_e1981 < _e1840));
let _e1989 = global_5.member[bitcast<u32>(select(0i, _e1983, (_e1983 > 0i)))];
let _e1996 = ((_e1977 >> bitcast<u32>((_e1969 & 31u))) | ((_e1989 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1969) & 31u))));
let _e1999 = f32(bitcast<i32>((_e1996 & 65535u)));
let _e2007 = (_e1913 + _e1899);
let _e2008 = (2i * _e2007);
let _e2010 = (_e2008 >> bitcast<u32>(2i));
let _e2013 = bitcast<u32>(((_e2008 & 3i) * 8i));
let _e2015 = select(_e1840, _e2010, (_e2010 < _e1840));
let _e2021 = global_5.member[bitcast<u32>(select(0i, _e2015, (_e2015 > 0i)))];
let _e2025 = (_e2010 + 1i);
let _e2027 = select(_e1840, _e2025, (_e2025 < _e1840));
let _e2033 = global_5.member[bitcast<u32>(select(0i, _e2027, (_e2027 > 0i)))];
let _e2040 = ((_e2021 >> bitcast<u32>((_e2013 & 31u))) | ((_e2033 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2013) & 31u))));
let _e2043 = f32(bitcast<i32>((_e2040 & 65535u)));
let _e2050 = (_e2043 + ((f32(bitcast<i32>((_e2040 >> bitcast<u32>(16i)))) - _e2043) * _e1915));
let _e2052 = (2i * (_e2007 + _e1874));
let _e2054 = (_e2052 >> bitcast<u32>(2i));
let _e2057 = bitcast<u32>(((_e2052 & 3i) * 8i));
let _e2059 = select(_e1840, _e2054, (_e2054 < _e1840));
let _e2065 = global_5.member[bitcast<u32>(select(0i, _e2059, (_e2059 > 0i)))];
let _e2069 = (_e2054 + 1i);
let _e2071 = select(_e1840, _e2069, (_e2069 < _e1840));
let _e2077 = global_5.member[bitcast<u32>(select(0i, _e2071, (_e2071 > 0i)))];
let _e2084 = ((_e2065 >> bitcast<u32>((_e2057 & 31u))) | ((_e2077 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2057) & 31u))));
let _e2087 = f32(bitcast<i32>((_e2084 & 65535u)));
let _e2097 = (_e1962 + (((_e1999 + ((f32(bitcast<i32>((_e1996 >> bitcast<u32>(16i)))) - _e1999) * _e1915)) - _e1962) * _e1917));
phi_3091_ = (_e2097 + (((_e2050 + (((_e2087 + ((f32(bitcast<i32>((_e2084 >> bitcast<u32>(16i)))) - _e2087) * _e1915)) - _e2050) * _e1917)) - _e2097) * (_e1785 - f32(_e1836))));
} else {
phi_3091_ = 0f;
}
let _e2105 = phi_3091_;
phi_2653_ = (_e1764 - 1i);
phi_2656_ = select(_e1766, _e1764, (_e2105 > 32767.5f));
} else {
phi_2653_ = i32();
phi_2656_ = i32();
}
let _e2110 = phi_2653_;
let _e2112 = phi_2656_;
continue;
continuing {
phi_2652_ = _e2110;
phi_2655_ = _e2112;
break if !(_e1767);
}
}
let _e2115 = local_8;
let _e2118 = local_9;
local = select(_e792.member_7, _e2118, (_e2115 < _e792.member_7));
local_1 = (_e792.member + vec3<f32>(_e1751, _e1754, _e1757));
let _e2123 = local;
let _e2124 = local_1[0u];
let _e2126 = local_1[1u];
let _e2128 = local_1[2u];
let _e2132 = global_1.member.member_2.member;
let _e2136 = global_1.member.member_2.member_1;
let _e2140 = global_1.member.member_2.member_2;
let _e2142 = ((_e2124 + -1f) - 0.5f);
let _e2143 = ((_e2126 + 0f) - 0.5f);
let _e2144 = ((_e2128 + 0f) - 0.5f);
let _e2146 = f32((bitcast<i32>(_e2132) - 2i));
let _e2148 = select(0f, _e2142, (_e2142 > 0f));
let _e2150 = select(_e2146, _e2148, (_e2148 < _e2146));
let _e2157 = select(0i, select(select(i32(_e2150), i32(-2147483648), (_e2150 < -2147483600f)), 2147483647i, (_e2150 > 2147483500f)), (_e2150 == _e2150));
let _e2161 = (_e2157 - select(0i, 1i, (_e2150 < f32(_e2157))));
let _e2163 = f32((bitcast<i32>(_e2136) - 2i));
let _e2165 = select(0f, _e2143, (_e2143 > 0f));
let _e2167 = select(_e2163, _e2165, (_e2165 < _e2163));
let _e2174 = select(0i, select(select(i32(_e2167), i32(-2147483648), (_e2167 < -2147483600f)), 2147483647i, (_e2167 > 2147483500f)), (_e2167 == _e2167));
let _e2178 = (_e2174 - select(0i, 1i, (_e2167 < f32(_e2174))));
let _e2180 = f32((bitcast<i32>(_e2140) - 2i));
let _e2182 = select(0f, _e2144, (_e2144 > 0f));
let _e2184 = select(_e2180, _e2182, (_e2182 < _e2180));
let _e2191 = select(0i, select(select(i32(_e2184), i32(-2147483648), (_e2184 < -2147483600f)), 2147483647i, (_e2184 > 2147483500f)), (_e2184 == _e2184));
let _e2195 = (_e2191 - select(0i, 1i, (_e2184 < f32(_e2191))));
let _e2196 = (_e2123 * 4i);
let _e2197 = (_e2196 + 1i);
let _e2199 = (bitcast<i32>(_e91) - 1i);
let _e2201 = select(_e2199, _e2197, (_e2197 < _e2199));
let _e2206 = global_5.member[bitcast<u32>(select(0i, _e2201, (_e2201 > 0i)))];
let _e2207 = (_e2196 + 2i);
let _e2209 = select(_e2199, _e2207, (_e2207 < _e2199));
let _e2214 = global_5.member[bitcast<u32>(select(0i, _e2209, (_e2209 > 0i)))];
let _e2215 = (_e2196 + 3i);
let _e2217 = select(_e2199, _e2215, (_e2215 < _e2199));
let _e2222 = global_5.member[bitcast<u32>(select(0i, _e2217, (_e2217 > 0i)))];
let _e2225 = (_e2161 - bitcast<i32>((_e2206 & 65535u)));
let _e2230 = bitcast<i32>((_e2206 >> bitcast<u32>(16i)));
let _e2235 = (_e2178 - bitcast<i32>((_e2214 & 65535u)));
let _e2240 = bitcast<i32>((_e2214 >> bitcast<u32>(16i)));
let _e2245 = (_e2195 - bitcast<i32>((_e2222 & 65535u)));
if ((((_e2225 >= 0i) && ((_e2225 + 1i) < _e2230)) && ((_e2235 >= 0i) && ((_e2235 + 1i) < _e2240))) && ((_e2245 >= 0i) && ((_e2245 + 1i) < bitcast<i32>((_e2222 >> bitcast<u32>(16i)))))) {
let _e2255 = (_e2240 * _e2230);
let _e2257 = select(_e2199, _e2196, (_e2196 < _e2199));
let _e2262 = global_5.member[bitcast<u32>(select(0i, _e2257, (_e2257 > 0i)))];
let _e2268 = (((bitcast<i32>(_e2262) + (_e2245 * _e2255)) + (_e2235 * _e2230)) + _e2225);
let _e2270 = (_e2142 - f32(_e2161));
let _e2272 = (_e2143 - f32(_e2178));
let _e2275 = (2i * _e2268);
let _e2277 = (_e2275 >> bitcast<u32>(2i));
let _e2280 = bitcast<u32>(((_e2275 & 3i) * 8i));
let _e2282 = select(_e2199, _e2277, (_e2277 < _e2199));
let _e2287 = global_5.member[bitcast<u32>(select(0i, _e2282, (_e2282 > 0i)))];
let _e2291 = (_e2277 + 1i);
let _e2293 = select(_e2199, _e2291, (_e2291 < _e2199));
let _e2298 = global_5.member[bitcast<u32>(select(0i, _e2293, (_e2293 > 0i)))];
let _e2305 = ((_e2287 >> bitcast<u32>((_e2280 & 31u))) | ((_e2298 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2280) & 31u))));
let _e2308 = f32(bitcast<i32>((_e2305 & 65535u)));
let _e2315 = (_e2308 + ((f32(bitcast<i32>((_e2305 >> bitcast<u32>(16i)))) - _e2308) * _e2270));
let _e2317 = (2i * (_e2268 + _e2230));
let _e2319 = (_e2317 >> bitcast<u32>(2i));
let _e2322 = bitcast<u32>(((_e2317 & 3i) * 8i));
let _e2324 = select(_e2199, _e2319, (_e2319 < _e2199));
let _e2329 = global_5.member[bitcast<u32>(select(0i, _e2324, (_e2324 > 0i)))];
let _e2333 = (_e2319 + 1i);
let _e2335 = select(_e2199, _e2333, (_e2333 < _e2199));
let _e2340 = global_5.member[bitcast<u32>(select(0i, _e2335, (_e2335 > 0i)))];
let _e2347 = ((_e2329 >> bitcast<u32>((_e2322 & 31u))) | ((_e2340 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2322) & 31u))));
let _e2350 = f32(bitcast<i32>((_e2347 & 65535u)));
let _e2358 = (_e2268 + _e2255);
let _e2359 = (2i * _e2358);
let _e2361 = (_e2359 >> bitcast<u32>(2i));
let _e2364 = bitcast<u32>(((_e2359 & 3i) * 8i));
let _e2366 = select(_e2199, _e2361, (_e2361 < _e2199));
let _e2371 = global_5.member[bitcast<u32>(select(0i, _e2366, (_e2366 > 0i)))];
let _e2375 = (_e2361 + 1i);
let _e2377 = select(_e2199, _e2375, (_e2375 < _e2199));
let _e2382 = global_5.member[bitcast<u32>(select(0i, _e2377, (_e2377 > 0i)))];
let _e2389 = ((_e2371 >> bitcast<u32>((_e2364 & 31u))) | ((_e2382 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2364) & 31u))));
let _e2392 = f32(bitcast<i32>((_e2389 & 65535u)));
let _e2399 = (_e2392 + ((f32(bitcast<i32>((_e2389 >> bitcast<u32>(16i)))) - _e2392) * _e2270));
let _e2401 = (2i * (_e2358 + _e2230));
let _e2403 = (_e2401 >> bitcast<u32>(2i));
let _e2406 = bitcast<u32>(((_e2401 & 3i) * 8i));
let _e2408 = select(_e2199, _e2403, (_e2403 < _e2199));
let _e2413 = global_5.member[bitcast<u32>(select(0i, _e2408, (_e2408 > 0i)))];
let _e2417 = (_e2403 + 1i);
let _e2419 = select(_e2199, _e2417, (_e2417 < _e2199));
let _e2424 = global_5.member[bitcast<u32>(select(0i, _e2419, (_e2419 > 0i)))];
let _e2431 = ((_e2413 >> bitcast<u32>((_e2406 & 31u))) | ((_e2424 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2406) & 31u))));
let _e2434 = f32(bitcast<i32>((_e2431 & 65535u)));
let _e2444 = (_e2315 + (((_e2350 + ((f32(bitcast<i32>((_e2347 >> bitcast<u32>(16i)))) - _e2350) * _e2270)) - _e2315) * _e2272));
phi_3551_ = (_e2444 + (((_e2399 + (((_e2434 + ((f32(bitcast<i32>((_e2431 >> bitcast<u32>(16i)))) - _e2434) * _e2270)) - _e2399) * _e2272)) - _e2444) * (_e2144 - f32(_e2195))));
} else {
phi_3551_ = 0f;
}
let _e2452 = phi_3551_;
let _e2453 = local;
let _e2454 = local_1[0u];
let _e2456 = local_1[1u];
let _e2458 = local_1[2u];
let _e2460 = ((_e2454 + 1f) - 0.5f);
let _e2461 = ((_e2456 + 0f) - 0.5f);
let _e2462 = ((_e2458 + 0f) - 0.5f);
let _e2464 = select(0f, _e2460, (_e2460 > 0f));
let _e2466 = select(_e2146, _e2464, (_e2464 < _e2146));
let _e2473 = select(0i, select(select(i32(_e2466), i32(-2147483648), (_e2466 < -2147483600f)), 2147483647i, (_e2466 > 2147483500f)), (_e2466 == _e2466));
let _e2477 = (_e2473 - select(0i, 1i, (_e2466 < f32(_e2473))));
let _e2479 = select(0f, _e2461, (_e2461 > 0f));
let _e2481 = select(_e2163, _e2479, (_e2479 < _e2163));
let _e2488 = select(0i, select(select(i32(_e2481), i32(-2147483648), (_e2481 < -2147483600f)), 2147483647i, (_e2481 > 2147483500f)), (_e2481 == _e2481));
let _e2492 = (_e2488 - select(0i, 1i, (_e2481 < f32(_e2488))));
let _e2494 = select(0f, _e2462, (_e2462 > 0f));
let _e2496 = select(_e2180, _e2494, (_e2494 < _e2180));
let _e2503 = select(0i, select(select(i32(_e2496), i32(-2147483648), (_e2496 < -2147483600f)), 2147483647i, (_e2496 > 2147483500f)), (_e2496 == _e2496));
let _e2507 = (_e2503 - select(0i, 1i, (_e2496 < f32(_e2503))));
let _e2508 = (_e2453 * 4i);
let _e2509 = (_e2508 + 1i);
let _e2511 = select(_e2199, _e2509, (_e2509 < _e2199));
let _e2516 = global_5.member[bitcast<u32>(select(0i, _e2511, (_e2511 > 0i)))];
let _e2517 = (_e2508 + 2i);
let _e2519 = select(_e2199, _e2517, (_e2517 < _e2199));
let _e2524 = global_5.member[bitcast<u32>(select(0i, _e2519, (_e2519 > 0i)))];
let _e2525 = (_e2508 + 3i);
let _e2527 = select(_e2199, _e2525, (_e2525 < _e2199));
let _e2532 = global_5.member[bitcast<u32>(select(0i, _e2527, (_e2527 > 0i)))];
let _e2535 = (_e2477 - bitcast<i32>((_e2516 & 65535u)));
let _e2540 = bitcast<i32>((_e2516 >> bitcast<u32>(16i)));
let _e2545 = (_e2492 - bitcast<i32>((_e2524 & 65535u)));
let _e2550 = bitcast<i32>((_e2524 >> bitcast<u32>(16i)));
let _e2555 = (_e2507 - bitcast<i32>((_e2532 & 65535u)));
if ((((_e2535 >= 0i) && ((_e2535 + 1i) < _e2540)) && ((_e2545 >= 0i) && ((_e2545 + 1i) < _e2550))) && ((_e2555 >= 0i) && ((_e2555 + 1i) < bitcast<i32>((_e2532 >> bitcast<u32>(16i)))))) {
let _e2565 = (_e2550 * _e2540);
let _e2567 = select(_e2199, _e2508, (_e2508 < _e2199));
let _e2572 = global_5.member[bitcast<u32>(select(0i, _e2567, (_e2567 > 0i)))];
let _e2578 = (((bitcast<i32>(_e2572) + (_e2555 * _e2565)) + (_e2545 * _e2540)) + _e2535);
let _e2580 = (_e2460 - f32(_e2477));
let _e2582 = (_e2461 - f32(_e2492));
let _e2585 = (2i * _e2578);
let _e2587 = (_e2585 >> bitcast<u32>(2i));
let _e2590 = bitcast<u32>(((_e2585 & 3i) * 8i));
let _e2592 = select(_e2199, _e2587, (_e2587 < _e2199));
let _e2597 = global_5.member[bitcast<u32>(select(0i, _e2592, (_e2592 > 0i)))];
let _e2601 = (_e2587 + 1i);
let _e2603 = select(_e2199, _e2601, (_e2601 < _e2199));
let _e2608 = global_5.member[bitcast<u32>(select(0i, _e2603, (_e2603 > 0i)))];
let _e2615 = ((_e2597 >> bitcast<u32>((_e2590 & 31u))) | ((_e2608 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2590) & 31u))));
let _e2618 = f32(bitcast<i32>((_e2615 & 65535u)));
let _e2625 = (_e2618 + ((f32(bitcast<i32>((_e2615 >> bitcast<u32>(16i)))) - _e2618) * _e2580));
let _e2627 = (2i * (_e2578 + _e2540));
let _e2629 = (_e2627 >> bitcast<u32>(2i));
let _e2632 = bitcast<u32>(((_e2627 & 3i) * 8i));
let _e2634 = select(_e2199, _e2629, (_e2629 < _e2199));
let _e2639 = global_5.member[bitcast<u32>(select(0i, _e2634, (_e2634 > 0i)))];
let _e2643 = (_e2629 + 1i);
let _e2645 = select(_e2199, _e2643, (_e2643 < _e2199));
let _e2650 = global_5.member[bitcast<u32>(select(0i, _e2645, (_e2645 > 0i)))];
let _e2657 = ((_e2639 >> bitcast<u32>((_e2632 & 31u))) | ((_e2650 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2632) & 31u))));
let _e2660 = f32(bitcast<i32>((_e2657 & 65535u)));
let _e2668 = (_e2578 + _e2565);
let _e2669 = (2i * _e2668);
let _e2671 = (_e2669 >> bitcast<u32>(2i));
let _e2674 = bitcast<u32>(((_e2669 & 3i) * 8i));
let _e2676 = select(_e2199, _e2671, (_e2671 < _e2199));
let _e2681 = global_5.member[bitcast<u32>(select(0i, _e2676, (_e2676 > 0i)))];
let _e2685 = (_e2671 + 1i);
let _e2687 = select(_e2199, _e2685, (_e2685 < _e2199));
let _e2692 = global_5.member[bitcast<u32>(select(0i, _e2687, (_e2687 > 0i)))];
let _e2699 = ((_e2681 >> bitcast<u32>((_e2674 & 31u))) | ((_e2692 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2674) & 31u))));
let _e2702 = f32(bitcast<i32>((_e2699 & 65535u)));
let _e2709 = (_e2702 + ((f32(bitcast<i32>((_e2699 >> bitcast<u32>(16i)))) - _e2702) * _e2580));
let _e2711 = (2i * (_e2668 + _e2540));
let _e2713 = (_e2711 >> bitcast<u32>(2i));
let _e2716 = bitcast<u32>(((_e2711 & 3i) * 8i));
let _e2718 = select(_e2199, _e2713, (_e2713 < _e2199));
let _e2723 = global_5.member[bitcast<u32>(select(0i, _e2718, (_e2718 > 0i)))];
let _e2727 = (_e2713 + 1i);
let _e2729 = select(_e2199, _e2727, (_e2727 < _e2199));
let _e2734 = global_5.member[bitcast<u32>(select(0i, _e2729, (_e2729 > 0i)))];
let _e2741 = ((_e2723 >> bitcast<u32>((_e2716 & 31u))) | ((_e2734 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2716) & 31u))));
let _e2744 = f32(bitcast<i32>((_e2741 & 65535u)));
let _e2754 = (_e2625 + (((_e2660 + ((f32(bitcast<i32>((_e2657 >> bitcast<u32>(16i)))) - _e2660) * _e2580)) - _e2625) * _e2582));
phi_3990_ = (_e2754 + (((_e2709 + (((_e2744 + ((f32(bitcast<i32>((_e2741 >> bitcast<u32>(16i)))) - _e2744) * _e2580)) - _e2709) * _e2582)) - _e2754) * (_e2462 - f32(_e2507))));
} else {
phi_3990_ = 0f;
}
let _e2762 = phi_3990_;
let _e2763 = (_e2452 - _e2762);
let _e2764 = local;
let _e2765 = local_1[0u];
let _e2767 = local_1[1u];
let _e2769 = local_1[2u];
let _e2771 = ((_e2765 + 0f) - 0.5f);
let _e2772 = ((_e2767 + -1f) - 0.5f);
let _e2773 = ((_e2769 + 0f) - 0.5f);
let _e2775 = select(0f, _e2771, (_e2771 > 0f));
let _e2777 = select(_e2146, _e2775, (_e2775 < _e2146));
let _e2784 = select(0i, select(select(i32(_e2777), i32(-2147483648), (_e2777 < -2147483600f)), 2147483647i, (_e2777 > 2147483500f)), (_e2777 == _e2777));
let _e2788 = (_e2784 - select(0i, 1i, (_e2777 < f32(_e2784))));
let _e2790 = select(0f, _e2772, (_e2772 > 0f));
let _e2792 = select(_e2163, _e2790, (_e2790 < _e2163));
let _e2799 = select(0i, select(select(i32(_e2792), i32(-2147483648), (_e2792 < -2147483600f)), 2147483647i, (_e2792 > 2147483500f)), (_e2792 == _e2792));
let _e2803 = (_e2799 - select(0i, 1i, (_e2792 < f32(_e2799))));
let _e2805 = select(0f, _e2773, (_e2773 > 0f));
let _e2807 = select(_e2180, _e2805, (_e2805 < _e2180));
let _e2814 = select(0i, select(select(i32(_e2807), i32(-2147483648), (_e2807 < -2147483600f)), 2147483647i, (_e2807 > 2147483500f)), (_e2807 == _e2807));
let _e2818 = (_e2814 - select(0i, 1i, (_e2807 < f32(_e2814))));
let _e2819 = (_e2764 * 4i);
let _e2820 = (_e2819 + 1i);
let _e2822 = select(_e2199, _e2820, (_e2820 < _e2199));
let _e2827 = global_5.member[bitcast<u32>(select(0i, _e2822, (_e2822 > 0i)))];
let _e2828 = (_e2819 + 2i);
let _e2830 = select(_e2199, _e2828, (_e2828 < _e2199));
let _e2835 = global_5.member[bitcast<u32>(select(0i, _e2830, (_e2830 > 0i)))];
let _e2836 = (_e2819 + 3i);
let _e2838 = select(_e2199, _e2836, (_e2836 < _e2199));
let _e2843 = global_5.member[bitcast<u32>(select(0i, _e2838, (_e2838 > 0i)))];
let _e2846 = (_e2788 - bitcast<i32>((_e2827 & 65535u)));
let _e2851 = bitcast<i32>((_e2827 >> bitcast<u32>(16i)));
let _e2856 = (_e2803 - bitcast<i32>((_e2835 & 65535u)));
let _e2861 = bitcast<i32>((_e2835 >> bitcast<u32>(16i)));
let _e2866 = (_e2818 - bitcast<i32>((_e2843 & 65535u)));
if ((((_e2846 >= 0i) && ((_e2846 + 1i) < _e2851)) && ((_e2856 >= 0i) && ((_e2856 + 1i) < _e2861))) && ((_e2866 >= 0i) && ((_e2866 + 1i) < bitcast<i32>((_e2843 >> bitcast<u32>(16i)))))) {
let _e2876 = (_e2861 * _e2851);
let _e2878 = select(_e2199, _e2819, (_e2819 < _e2199));
let _e2883 = global_5.member[bitcast<u32>(select(0i, _e2878, (_e2878 > 0i)))];
let _e2889 = (((bitcast<i32>(_e2883) + (_e2866 * _e2876)) + (_e2856 * _e2851)) + _e2846);
let _e2891 = (_e2771 - f32(_e2788));
let _e2893 = (_e2772 - f32(_e2803));
let _e2896 = (2i * _e2889);
let _e2898 = (_e2896 >> bitcast<u32>(2i));
let _e2901 = bitcast<u32>(((_e2896 & 3i) * 8i));
let _e2903 = select(_e2199, _e2898, (_e2898 < _e2199));
let _e2908 = global_5.member[bitcast<u32>(select(0i, _e2903, (_e2903 > 0i)))];
let _e2912 = (_e2898 + 1i);
let _e2914 = select(_e2199, _e2912, (_e2912 < _e2199));
let _e2919 = global_5.member[bitcast<u32>(select(0i, _e2914, (_e2914 > 0i)))];
let _e2926 = ((_e2908 >> bitcast<u32>((_e2901 & 31u))) | ((_e2919 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2901) & 31u))));
let _e2929 = f32(bitcast<i32>((_e2926 & 65535u)));
let _e2936 = (_e2929 + ((f32(bitcast<i32>((_e2926 >> bitcast<u32>(16i)))) - _e2929) * _e2891));
let _e2938 = (2i * (_e2889 + _e2851));
let _e2940 = (_e2938 >> bitcast<u32>(2i));
let _e2943 = bitcast<u32>(((_e2938 & 3i) * 8i));
let _e2945 = select(_e2199, _e2940, (_e2940 < _e2199));
let _e2950 = global_5.member[bitcast<u32>(select(0i, _e2945, (_e2945 > 0i)))];
let _e2954 = (_e2940 + 1i);
let _e2956 = select(_e2199, _e2954, (_e2954 < _e2199));
let _e2961 = global_5.member[bitcast<u32>(select(0i, _e2956, (_e2956 > 0i)))];
let _e2968 = ((_e2950 >> bitcast<u32>((_e2943 & 31u))) | ((_e2961 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2943) & 31u))));
let _e2971 = f32(bitcast<i32>((_e2968 & 65535u)));
let _e2979 = (_e2889 + _e2876);
let _e2980 = (2i * _e2979);
let _e2982 = (_e2980 >> bitcast<u32>(2i));
let _e2985 = bitcast<u32>(((_e2980 & 3i) * 8i));
let _e2987 = select(_e2199, _e2982, (_e2982 < _e2199));
let _e2992 = global_5.member[bitcast<u32>(select(0i, _e2987, (_e2987 > 0i)))];
let _e2996 = (_e2982 + 1i);
let _e2998 = select(_e2199, _e2996, (_e2996 < _e2199));
let _e3003 = global_5.member[bitcast<u32>(select(0i, _e2998, (_e2998 > 0i)))];
let _e3010 = ((_e2992 >> bitcast<u32>((_e2985 & 31u))) | ((_e3003 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2985) & 31u))));
let _e3013 = f32(bitcast<i32>((_e3010 & 65535u)));
let _e3020 = (_e3013 + ((f32(bitcast<i32>((_e3010 >> bitcast<u32>(16i)))) - _e3013) * _e2891));
let _e3022 = (2i * (_e2979 + _e2851));
let _e3024 = (_e3022 >> bitcast<u32>(2i));
let _e3027 = bitcast<u32>(((_e3022 & 3i) * 8i));
let _e3029 = select(_e2199, _e3024, (_e3024 < _e2199));
let _e3034 = global_5.member[bitcast<u32>(select(0i, _e3029, (_e3029 > 0i)))];
let _e3038 = (_e3024 + 1i);
let _e3040 = select(_e2199, _e3038, (_e3038 < _e2199));
let _e3045 = global_5.member[bitcast<u32>(select(0i, _e3040, (_e3040 > 0i)))];
let _e3052 = ((_e3034 >> bitcast<u32>((_e3027 & 31u))) | ((_e3045 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3027) & 31u))));
let _e3055 = f32(bitcast<i32>((_e3052 & 65535u)));
let _e3065 = (_e2936 + (((_e2971 + ((f32(bitcast<i32>((_e2968 >> bitcast<u32>(16i)))) - _e2971) * _e2891)) - _e2936) * _e2893));
phi_4430_ = (_e3065 + (((_e3020 + (((_e3055 + ((f32(bitcast<i32>((_e3052 >> bitcast<u32>(16i)))) - _e3055) * _e2891)) - _e3020) * _e2893)) - _e3065) * (_e2773 - f32(_e2818))));
} else {
phi_4430_ = 0f;
}
let _e3073 = phi_4430_;
let _e3074 = local;
let _e3075 = local_1[0u];
let _e3077 = local_1[1u];
let _e3079 = local_1[2u];
let _e3081 = ((_e3075 + 0f) - 0.5f);
let _e3082 = ((_e3077 + 1f) - 0.5f);
let _e3083 = ((_e3079 + 0f) - 0.5f);
let _e3085 = select(0f, _e3081, (_e3081 > 0f));
let _e3087 = select(_e2146, _e3085, (_e3085 < _e2146));
let _e3094 = select(0i, select(select(i32(_e3087), i32(-2147483648), (_e3087 < -2147483600f)), 2147483647i, (_e3087 > 2147483500f)), (_e3087 == _e3087));
let _e3098 = (_e3094 - select(0i, 1i, (_e3087 < f32(_e3094))));
let _e3100 = select(0f, _e3082, (_e3082 > 0f));
let _e3102 = select(_e2163, _e3100, (_e3100 < _e2163));
let _e3109 = select(0i, select(select(i32(_e3102), i32(-2147483648), (_e3102 < -2147483600f)), 2147483647i, (_e3102 > 2147483500f)), (_e3102 == _e3102));
let _e3113 = (_e3109 - select(0i, 1i, (_e3102 < f32(_e3109))));
let _e3115 = select(0f, _e3083, (_e3083 > 0f));
let _e3117 = select(_e2180, _e3115, (_e3115 < _e2180));
let _e3124 = select(0i, select(select(i32(_e3117), i32(-2147483648), (_e3117 < -2147483600f)), 2147483647i, (_e3117 > 2147483500f)), (_e3117 == _e3117));
let _e3128 = (_e3124 - select(0i, 1i, (_e3117 < f32(_e3124))));
let _e3129 = (_e3074 * 4i);
let _e3130 = (_e3129 + 1i);
let _e3132 = select(_e2199, _e3130, (_e3130 < _e2199));
let _e3137 = global_5.member[bitcast<u32>(select(0i, _e3132, (_e3132 > 0i)))];
let _e3138 = (_e3129 + 2i);
let _e3140 = select(_e2199, _e3138, (_e3138 < _e2199));
let _e3145 = global_5.member[bitcast<u32>(select(0i, _e3140, (_e3140 > 0i)))];
let _e3146 = (_e3129 + 3i);
let _e3148 = select(_e2199, _e3146, (_e3146 < _e2199));
let _e3153 = global_5.member[bitcast<u32>(select(0i, _e3148, (_e3148 > 0i)))];
let _e3156 = (_e3098 - bitcast<i32>((_e3137 & 65535u)));
let _e3161 = bitcast<i32>((_e3137 >> bitcast<u32>(16i)));
let _e3166 = (_e3113 - bitcast<i32>((_e3145 & 65535u)));
let _e3171 = bitcast<i32>((_e3145 >> bitcast<u32>(16i)));
let _e3176 = (_e3128 - bitcast<i32>((_e3153 & 65535u)));
if ((((_e3156 >= 0i) && ((_e3156 + 1i) < _e3161)) && ((_e3166 >= 0i) && ((_e3166 + 1i) < _e3171))) && ((_e3176 >= 0i) && ((_e3176 + 1i) < bitcast<i32>((_e3153 >> bitcast<u32>(16i)))))) {
let _e3186 = (_e3171 * _e3161);
let _e3188 = select(_e2199, _e3129, (_e3129 < _e2199));
let _e3193 = global_5.member[bitcast<u32>(select(0i, _e3188, (_e3188 > 0i)))];
let _e3199 = (((bitcast<i32>(_e3193) + (_e3176 * _e3186)) + (_e3166 * _e3161)) + _e3156);
let _e3201 = (_e3081 - f32(_e3098));
let _e3203 = (_e3082 - f32(_e3113));
let _e3206 = (2i * _e3199);
let _e3208 = (_e3206 >> bitcast<u32>(2i));
let _e3211 = bitcast<u32>(((_e3206 & 3i) * 8i));
let _e3213 = select(_e2199, _e3208, (_e3208 < _e2199));
let _e3218 = global_5.member[bitcast<u32>(select(0i, _e3213, (_e3213 > 0i)))];
let _e3222 = (_e3208 + 1i);
let _e3224 = select(_e2199, _e3222, (_e3222 < _e2199));
let _e3229 = global_5.member[bitcast<u32>(select(0i, _e3224, (_e3224 > 0i)))];
let _e3236 = ((_e3218 >> bitcast<u32>((_e3211 & 31u))) | ((_e3229 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3211) & 31u))));
let _e3239 = f32(bitcast<i32>((_e3236 & 65535u)));
let _e3246 = (_e3239 + ((f32(bitcast<i32>((_e3236 >> bitcast<u32>(16i)))) - _e3239) * _e3201));
let _e3248 = (2i * (_e3199 + _e3161));
let _e3250 = (_e3248 >> bitcast<u32>(2i));
let _e3253 = bitcast<u32>(((_e3248 & 3i) * 8i));
let _e3255 = select(_e2199, _e3250, (_e3250 < _e2199));
let _e3260 = global_5.member[bitcast<u32>(select(0i, _e3255, (_e3255 > 0i)))];
let _e3264 = (_e3250 + 1i);
let _e3266 = select(_e2199, _e3264, (_e3264 < _e2199));
let _e3271 = global_5.member[bitcast<u32>(select(0i, _e3266, (_e3266 > 0i)))];
let _e3278 = ((_e3260 >> bitcast<u32>((_e3253 & 31u))) | ((_e3271 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3253) & 31u))));
let _e3281 = f32(bitcast<i32>((_e3278 & 65535u)));
let _e3289 = (_e3199 + _e3186);
let _e3290 = (2i * _e3289);
let _e3292 = (_e3290 >> bitcast<u32>(2i));
let _e3295 = bitcast<u32>(((_e3290 & 3i) * 8i));
let _e3297 = select(_e2199, _e3292, (_e3292 < _e2199));
let _e3302 = global_5.member[bitcast<u32>(select(0i, _e3297, (_e3297 > 0i)))];
let _e3306 = (_e3292 + 1i);
let _e3308 = select(_e2199, _e3306, (_e3306 < _e2199));
let _e3313 = global_5.member[bitcast<u32>(select(0i, _e3308, (_e3308 > 0i)))];
let _e3320 = ((_e3302 >> bitcast<u32>((_e3295 & 31u))) | ((_e3313 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3295) & 31u))));
let _e3323 = f32(bitcast<i32>((_e3320 & 65535u)));
let _e3330 = (_e3323 + ((f32(bitcast<i32>((_e3320 >> bitcast<u32>(16i)))) - _e3323) * _e3201));
let _e3332 = (2i * (_e3289 + _e3161));
let _e3334 = (_e3332 >> bitcast<u32>(2i));
let _e3337 = bitcast<u32>(((_e3332 & 3i) * 8i));
let _e3339 = select(_e2199, _e3334, (_e3334 < _e2199));
let _e3344 = global_5.member[bitcast<u32>(select(0i, _e3339, (_e3339 > 0i)))];
let _e3348 = (_e3334 + 1i);
let _e3350 = select(_e2199, _e3348, (_e3348 < _e2199));
let _e3355 = global_5.member[bitcast<u32>(select(0i, _e3350, (_e3350 > 0i)))];
let _e3362 = ((_e3344 >> bitcast<u32>((_e3337 & 31u))) | ((_e3355 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3337) & 31u))));
let _e3365 = f32(bitcast<i32>((_e3362 & 65535u)));
let _e3375 = (_e3246 + (((_e3281 + ((f32(bitcast<i32>((_e3278 >> bitcast<u32>(16i)))) - _e3281) * _e3201)) - _e3246) * _e3203));
phi_4869_ = (_e3375 + (((_e3330 + (((_e3365 + ((f32(bitcast<i32>((_e3362 >> bitcast<u32>(16i)))) - _e3365) * _e3201)) - _e3330) * _e3203)) - _e3375) * (_e3083 - f32(_e3128))));
} else {
phi_4869_ = 0f;
}
let _e3383 = phi_4869_;
let _e3384 = (_e3073 - _e3383);
let _e3385 = local;
let _e3386 = local_1[0u];
let _e3388 = local_1[1u];
let _e3390 = local_1[2u];
let _e3392 = ((_e3386 + 0f) - 0.5f);
let _e3393 = ((_e3388 + 0f) - 0.5f);
let _e3394 = ((_e3390 + -1f) - 0.5f);
let _e3396 = select(0f, _e3392, (_e3392 > 0f));
let _e3398 = select(_e2146, _e3396, (_e3396 < _e2146));
let _e3405 = select(0i, select(select(i32(_e3398), i32(-2147483648), (_e3398 < -2147483600f)), 2147483647i, (_e3398 > 2147483500f)), (_e3398 == _e3398));
let _e3409 = (_e3405 - select(0i, 1i, (_e3398 < f32(_e3405))));
let _e3411 = select(0f, _e3393, (_e3393 > 0f));
let _e3413 = select(_e2163, _e3411, (_e3411 < _e2163));
let _e3420 = select(0i, select(select(i32(_e3413), i32(-2147483648), (_e3413 < -2147483600f)), 2147483647i, (_e3413 > 2147483500f)), (_e3413 == _e3413));
let _e3424 = (_e3420 - select(0i, 1i, (_e3413 < f32(_e3420))));
let _e3426 = select(0f, _e3394, (_e3394 > 0f));
let _e3428 = select(_e2180, _e3426, (_e3426 < _e2180));
let _e3435 = select(0i, select(select(i32(_e3428), i32(-2147483648), (_e3428 < -2147483600f)), 2147483647i, (_e3428 > 2147483500f)), (_e3428 == _e3428));
let _e3439 = (_e3435 - select(0i, 1i, (_e3428 < f32(_e3435))));
let _e3440 = (_e3385 * 4i);
let _e3441 = (_e3440 + 1i);
let _e3443 = select(_e2199, _e3441, (_e3441 < _e2199));
let _e3448 = global_5.member[bitcast<u32>(select(0i, _e3443, (_e3443 > 0i)))];
let _e3449 = (_e3440 + 2i);
let _e3451 = select(_e2199, _e3449, (_e3449 < _e2199));
let _e3456 = global_5.member[bitcast<u32>(select(0i, _e3451, (_e3451 > 0i)))];
let _e3457 = (_e3440 + 3i);
let _e3459 = select(_e2199, _e3457, (_e3457 < _e2199));
let _e3464 = global_5.member[bitcast<u32>(select(0i, _e3459, (_e3459 > 0i)))];
let _e3467 = (_e3409 - bitcast<i32>((_e3448 & 65535u)));
let _e3472 = bitcast<i32>((_e3448 >> bitcast<u32>(16i)));
let _e3477 = (_e3424 - bitcast<i32>((_e3456 & 65535u)));
let _e3482 = bitcast<i32>((_e3456 >> bitcast<u32>(16i)));
let _e3487 = (_e3439 - bitcast<i32>((_e3464 & 65535u)));
if ((((_e3467 >= 0i) && ((_e3467 + 1i) < _e3472)) && ((_e3477 >= 0i) && ((_e3477 + 1i) < _e3482))) && ((_e3487 >= 0i) && ((_e3487 + 1i) < bitcast<i32>((_e3464 >> bitcast<u32>(16i)))))) {
let _e3497 = (_e3482 * _e3472);
let _e3499 = select(_e2199, _e3440, (_e3440 < _e2199));
let _e3504 = global_5.member[bitcast<u32>(select(0i, _e3499, (_e3499 > 0i)))];
let _e3510 = (((bitcast<i32>(_e3504) + (_e3487 * _e3497)) + (_e3477 * _e3472)) + _e3467);
let _e3512 = (_e3392 - f32(_e3409));
let _e3514 = (_e3393 - f32(_e3424));
let _e3517 = (2i * _e3510);
let _e3519 = (_e3517 >> bitcast<u32>(2i));
let _e3522 = bitcast<u32>(((_e3517 & 3i) * 8i));
let _e3524 = select(_e2199, _e3519, (_e3519 < _e2199));
let _e3529 = global_5.member[bitcast<u32>(select(0i, _e3524, (_e3524 > 0i)))];
let _e3533 = (_e3519 + 1i);
let _e3535 = select(_e2199, _e3533, (_e3533 < _e2199));
let _e3540 = global_5.member[bitcast<u32>(select(0i, _e3535, (_e3535 > 0i)))];
let _e3547 = ((_e3529 >> bitcast<u32>((_e3522 & 31u))) | ((_e3540 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3522) & 31u))));
let _e3550 = f32(bitcast<i32>((_e3547 & 65535u)));
let _e3557 = (_e3550 + ((f32(bitcast<i32>((_e3547 >> bitcast<u32>(16i)))) - _e3550) * _e3512));
let _e3559 = (2i * (_e3510 + _e3472));
let _e3561 = (_e3559 >> bitcast<u32>(2i));
let _e3564 = bitcast<u32>(((_e3559 & 3i) * 8i));
let _e3566 = select(_e2199, _e3561, (_e3561 < _e2199));
let _e3571 = global_5.member[bitcast<u32>(select(0i, _e3566, (_e3566 > 0i)))];
let _e3575 = (_e3561 + 1i);
let _e3577 = select(_e2199, _e3575, (_e3575 < _e2199));
let _e3582 = global_5.member[bitcast<u32>(select(0i, _e3577, (_e3577 > 0i)))];
let _e3589 = ((_e3571 >> bitcast<u32>((_e3564 & 31u))) | ((_e3582 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3564) & 31u))));
let _e3592 = f32(bitcast<i32>((_e3589 & 65535u)));
let _e3600 = (_e3510 + _e3497);
let _e3601 = (2i * _e3600);
let _e3603 = (_e3601 >> bitcast<u32>(2i));
let _e3606 = bitcast<u32>(((_e3601 & 3i) * 8i));
let _e3608 = select(_e2199, _e3603, (_e3603 < _e2199));
let _e3613 = global_5.member[bitcast<u32>(select(0i, _e3608, (_e3608 > 0i)))];
let _e3617 = (_e3603 + 1i);
let _e3619 = select(_e2199, _e3617, (_e3617 < _e2199));
let _e3624 = global_5.member[bitcast<u32>(select(0i, _e3619, (_e3619 > 0i)))];
let _e3631 = ((_e3613 >> bitcast<u32>((_e3606 & 31u))) | ((_e3624 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3606) & 31u))));
let _e3634 = f32(bitcast<i32>((_e3631 & 65535u)));
let _e3641 = (_e3634 + ((f32(bitcast<i32>((_e3631 >> bitcast<u32>(16i)))) - _e3634) * _e3512));
let _e3643 = (2i * (_e3600 + _e3472));
let _e3645 = (_e3643 >> bitcast<u32>(2i));
let _e3648 = bitcast<u32>(((_e3643 & 3i) * 8i));
let _e3650 = select(_e2199, _e3645, (_e3645 < _e2199));
let _e3655 = global_5.member[bitcast<u32>(select(0i, _e3650, (_e3650 > 0i)))];
let _e3659 = (_e3645 + 1i);
let _e3661 = select(_e2199, _e3659, (_e3659 < _e2199));
let _e3666 = global_5.member[bitcast<u32>(select(0i, _e3661, (_e3661 > 0i)))];
let _e3673 = ((_e3655 >> bitcast<u32>((_e3648 & 31u))) | ((_e3666 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3648) & 31u))));
let _e3676 = f32(bitcast<i32>((_e3673 & 65535u)));
let _e3686 = (_e3557 + (((_e3592 + ((f32(bitcast<i32>((_e3589 >> bitcast<u32>(16i)))) - _e3592) * _e3512)) - _e3557) * _e3514));
phi_5309_ = (_e3686 + (((_e3641 + (((_e3676 + ((f32(bitcast<i32>((_e3673 >> bitcast<u32>(16i)))) - _e3676) * _e3512)) - _e3641) * _e3514)) - _e3686) * (_e3394 - f32(_e3439))));
} else {
phi_5309_ = 0f;
}
let _e3694 = phi_5309_;
let _e3695 = local;
let _e3696 = local_1[0u];
let _e3698 = local_1[1u];
let _e3700 = local_1[2u];
let _e3702 = ((_e3696 + 0f) - 0.5f);
let _e3703 = ((_e3698 + 0f) - 0.5f);
let _e3704 = ((_e3700 + 1f) - 0.5f);
let _e3706 = select(0f, _e3702, (_e3702 > 0f));
let _e3708 = select(_e2146, _e3706, (_e3706 < _e2146));
let _e3715 = select(0i, select(select(i32(_e3708), i32(-2147483648), (_e3708 < -2147483600f)), 2147483647i, (_e3708 > 2147483500f)), (_e3708 == _e3708));
let _e3719 = (_e3715 - select(0i, 1i, (_e3708 < f32(_e3715))));
let _e3721 = select(0f, _e3703, (_e3703 > 0f));
let _e3723 = select(_e2163, _e3721, (_e3721 < _e2163));
let _e3730 = select(0i, select(select(i32(_e3723), i32(-2147483648), (_e3723 < -2147483600f)), 2147483647i, (_e3723 > 2147483500f)), (_e3723 == _e3723));
let _e3734 = (_e3730 - select(0i, 1i, (_e3723 < f32(_e3730))));
let _e3736 = select(0f, _e3704, (_e3704 > 0f));
let _e3738 = select(_e2180, _e3736, (_e3736 < _e2180));
let _e3745 = select(0i, select(select(i32(_e3738), i32(-2147483648), (_e3738 < -2147483600f)), 2147483647i, (_e3738 > 2147483500f)), (_e3738 == _e3738));
let _e3749 = (_e3745 - select(0i, 1i, (_e3738 < f32(_e3745))));
let _e3750 = (_e3695 * 4i);
let _e3751 = (_e3750 + 1i);
let _e3753 = select(_e2199, _e3751, (_e3751 < _e2199));
let _e3758 = global_5.member[bitcast<u32>(select(0i, _e3753, (_e3753 > 0i)))];
let _e3759 = (_e3750 + 2i);
let _e3761 = select(_e2199, _e3759, (_e3759 < _e2199));
let _e3766 = global_5.member[bitcast<u32>(select(0i, _e3761, (_e3761 > 0i)))];
let _e3767 = (_e3750 + 3i);
let _e3769 = select(_e2199, _e3767, (_e3767 < _e2199));
let _e3774 = global_5.member[bitcast<u32>(select(0i, _e3769, (_e3769 > 0i)))];
let _e3777 = (_e3719 - bitcast<i32>((_e3758 & 65535u)));
let _e3782 = bitcast<i32>((_e3758 >> bitcast<u32>(16i)));
let _e3787 = (_e3734 - bitcast<i32>((_e3766 & 65535u)));
let _e3792 = bitcast<i32>((_e3766 >> bitcast<u32>(16i)));
let _e3797 = (_e3749 - bitcast<i32>((_e3774 & 65535u)));
if ((((_e3777 >= 0i) && ((_e3777 + 1i) < _e3782)) && ((_e3787 >= 0i) && ((_e3787 + 1i) < _e3792))) && ((_e3797 >= 0i) && ((_e3797 + 1i) < bitcast<i32>((_e3774 >> bitcast<u32>(16i)))))) {
let _e3807 = (_e3792 * _e3782);
let _e3809 = select(_e2199, _e3750, (_e3750 < _e2199));
let _e3814 = global_5.member[bitcast<u32>(select(0i, _e3809, (_e3809 > 0i)))];
let _e3820 = (((bitcast<i32>(_e3814) + (_e3797 * _e3807)) + (_e3787 * _e3782)) + _e3777);
let _e3822 = (_e3702 - f32(_e3719));
let _e3824 = (_e3703 - f32(_e3734));
let _e3827 = (2i * _e3820);
let _e3829 = (_e3827 >> bitcast<u32>(2i));
let _e3832 = bitcast<u32>(((_e3827 & 3i) * 8i));
let _e3834 = select(_e2199, _e3829, (_e3829 < _e2199));
let _e3839 = global_5.member[bitcast<u32>(select(0i, _e3834, (_e3834 > 0i)))];
let _e3843 = (_e3829 + 1i);
let _e3845 = select(_e2199, _e3843, (_e3843 < _e2199));
let _e3850 = global_5.member[bitcast<u32>(select(0i, _e3845, (_e3845 > 0i)))];
let _e3857 = ((_e3839 >> bitcast<u32>((_e3832 & 31u))) | ((_e3850 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3832) & 31u))));
let _e3860 = f32(bitcast<i32>((_e3857 & 65535u)));
let _e3867 = (_e3860 + ((f32(bitcast<i32>((_e3857 >> bitcast<u32>(16i)))) - _e3860) * _e3822));
let _e3869 = (2i * (_e3820 + _e3782));
let _e3871 = (_e3869 >> bitcast<u32>(2i));
let _e3874 = bitcast<u32>(((_e3869 & 3i) * 8i));
let _e3876 = select(_e2199, _e3871, (_e3871 < _e2199));
let _e3881 = global_5.member[bitcast<u32>(select(0i, _e3876, (_e3876 > 0i)))];
let _e3885 = (_e3871 + 1i);
let _e3887 = select(_e2199, _e3885, (_e3885 < _e2199));
let _e3892 = global_5.member[bitcast<u32>(select(0i, _e3887, (_e3887 > 0i)))];
let _e3899 = ((_e3881 >> bitcast<u32>((_e3874 & 31u))) | ((_e3892 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3874) & 31u))));
let _e3902 = f32(bitcast<i32>((_e3899 & 65535u)));
let _e3910 = (_e3820 + _e3807);
let _e3911 = (2i * _e3910);
let _e3913 = (_e3911 >> bitcast<u32>(2i));
let _e3916 = bitcast<u32>(((_e3911 & 3i) * 8i));
let _e3918 = select(_e2199, _e3913, (_e3913 < _e2199));
let _e3923 = global_5.member[bitcast<u32>(select(0i, _e3918, (_e3918 > 0i)))];
let _e3927 = (_e3913 + 1i);
let _e3929 = select(_e2199, _e3927, (_e3927 < _e2199));
let _e3934 = global_5.member[bitcast<u32>(select(0i, _e3929, (_e3929 > 0i)))];
let _e3941 = ((_e3923 >> bitcast<u32>((_e3916 & 31u))) | ((_e3934 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3916) & 31u))));
let _e3944 = f32(bitcast<i32>((_e3941 & 65535u)));
let _e3951 = (_e3944 + ((f32(bitcast<i32>((_e3941 >> bitcast<u32>(16i)))) - _e3944) * _e3822));
let _e3953 = (2i * (_e3910 + _e3782));
let _e3955 = (_e3953 >> bitcast<u32>(2i));
let _e3958 = bitcast<u32>(((_e3953 & 3i) * 8i));
let _e3960 = select(_e2199, _e3955, (_e3955 < _e2199));
let _e3965 = global_5.member[bitcast<u32>(select(0i, _e3960, (_e3960 > 0i)))];
let _e3969 = (_e3955 + 1i);
let _e3971 = select(_e2199, _e3969, (_e3969 < _e2199));
let _e3976 = global_5.member[bitcast<u32>(select(0i, _e3971, (_e3971 > 0i)))];
let _e3983 = ((_e3965 >> bitcast<u32>((_e3958 & 31u))) | ((_e3976 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3958) & 31u))));
let _e3986 = f32(bitcast<i32>((_e3983 & 65535u)));
let _e3996 = (_e3867 + (((_e3902 + ((f32(bitcast<i32>((_e3899 >> bitcast<u32>(16i)))) - _e3902) * _e3822)) - _e3867) * _e3824));
phi_5748_ = (_e3996 + (((_e3951 + (((_e3986 + ((f32(bitcast<i32>((_e3983 >> bitcast<u32>(16i)))) - _e3986) * _e3822)) - _e3951) * _e3824)) - _e3996) * (_e3704 - f32(_e3749))));
} else {
phi_5748_ = 0f;
}
let _e4004 = phi_5748_;
let _e4005 = (_e3694 - _e4004);
let _e4010 = (((_e2763 * _e2763) + (_e3384 * _e3384)) + (_e4005 * _e4005));
let _e4013 = sqrt(select(0f, _e4010, (_e4010 > 0f)));
let _e4016 = (1f / select(1e-6f, _e4013, (_e4013 > 1e-6f)));
let _e4017 = (_e2763 * _e4016);
let _e4018 = (_e3384 * _e4016);
let _e4019 = (_e4005 * _e4016);
let _e4020 = vec3<f32>(_e4017, _e4018, _e4019);
let _e4023 = local_10;
let _e4027 = global_1.member.member_13;
let _e4040 = global_1.member.member_12;
let _e4044 = local_11;
let _e4046 = ((((_e792.member_5 + _e4023) < _e4027) && ((((_e4017 * _e792.member_4.x) + (_e4018 * _e792.member_4.y)) + (_e4019 * _e792.member_4.z)) > _e4040)) || (_e4044 == _e792.member_7));
if _e4046 {
phi_6811_ = _e792;
} else {
let _e4071 = type_20(vec3<f32>((_e792.member.x + _e1751), (_e792.member.y + _e1754), (_e792.member.z + _e1757)), _e792.member_1, _e792.member_2, _e792.member_3, _e792.member_4, _e792.member_5, _e792.member_6, _e792.member_7, _e792.member_8, _e792.member_9, _e792.member_10, _e792.member_11, _e792.member_12, _e792.member_13, _e792.member_14);
let _e4075 = local_12;
let _e4093 = type_20(_e4071.member, _e4071.member_1, _e4071.member_2, _e4071.member_3, _e4071.member_4, _e4071.member_5, _e4071.member_6, _e4071.member_7, _e4071.member_8, _e4071.member_9, (_e792.member_10 + select(0f, _e4075, (_e792.member_8 == 0f))), _e4071.member_11, _e4071.member_12, _e4071.member_13, _e4071.member_14);
if (_e792.member_7 != 16i) {
let _e4097 = local_13;
let _e4113 = type_20(_e4093.member, _e4093.member_1, _e4093.member_2, _e4093.member_3, _e4093.member_4, _e4093.member_5, _e4093.member_6, _e4093.member_7, _e4093.member_8, (_e792.member_9 + _e4097), _e4093.member_10, _e4093.member_11, _e4093.member_12, _e4093.member_13, _e4093.member_14);
let _e4114 = (_e792.member_7 * 4i);
let _e4115 = (_e4114 + 1i);
let _e4117 = (bitcast<i32>(_e93) - 1i);
let _e4119 = select(_e4117, _e4115, (_e4115 < _e4117));
let _e4125 = global_2.member[bitcast<u32>(select(0i, _e4119, (_e4119 > 0i)))];
let _e4127 = local_14;
let _e4129 = -((_e4125 * _e4127));
let _e4131 = select(-87f, _e4129, (_e4129 > -87f));
let _e4133 = select(88f, _e4131, (_e4131 < 88f));
let _e4135 = ((_e4133 * 1.442695f) + 0.5f);
let _e4137 = select(-127f, _e4135, (_e4135 > -127f));
let _e4139 = select(128f, _e4137, (_e4137 < 128f));
let _e4146 = select(0i, select(select(i32(_e4139), i32(-2147483648), (_e4139 < -2147483600f)), 2147483647i, (_e4139 > 2147483500f)), (_e4139 == _e4139));
let _e4150 = (_e4146 - select(0i, 1i, (_e4139 < f32(_e4146))));
let _e4151 = f32(_e4150);
let _e4155 = ((_e4133 - (_e4151 * 0.6933594f)) - (_e4151 * -2.1219444e-4f));
let _e4179 = (_e4114 + 2i);
let _e4181 = select(_e4117, _e4179, (_e4179 < _e4117));
let _e4187 = global_2.member[bitcast<u32>(select(0i, _e4181, (_e4181 > 0i)))];
let _e4189 = local_15;
let _e4191 = -((_e4187 * _e4189));
let _e4193 = select(-87f, _e4191, (_e4191 > -87f));
let _e4195 = select(88f, _e4193, (_e4193 < 88f));
let _e4197 = ((_e4195 * 1.442695f) + 0.5f);
let _e4199 = select(-127f, _e4197, (_e4197 > -127f));
let _e4201 = select(128f, _e4199, (_e4199 < 128f));
let _e4208 = select(0i, select(select(i32(_e4201), i32(-2147483648), (_e4201 < -2147483600f)), 2147483647i, (_e4201 > 2147483500f)), (_e4201 == _e4201));
let _e4212 = (_e4208 - select(0i, 1i, (_e4201 < f32(_e4208))));
let _e4213 = f32(_e4212);
let _e4217 = ((_e4195 - (_e4213 * 0.6933594f)) - (_e4213 * -2.1219444e-4f));
let _e4241 = (_e4114 + 3i);
let _e4243 = select(_e4117, _e4241, (_e4241 < _e4117));
let _e4249 = global_2.member[bitcast<u32>(select(0i, _e4243, (_e4243 > 0i)))];
let _e4251 = local_16;
let _e4253 = -((_e4249 * _e4251));
let _e4255 = select(-87f, _e4253, (_e4253 > -87f));
let _e4257 = select(88f, _e4255, (_e4255 < 88f));
let _e4259 = ((_e4257 * 1.442695f) + 0.5f);
let _e4261 = select(-127f, _e4259, (_e4259 > -127f));
let _e4263 = select(128f, _e4261, (_e4261 < 128f));
let _e4270 = select(0i, select(select(i32(_e4263), i32(-2147483648), (_e4263 < -2147483600f)), 2147483647i, (_e4263 > 2147483500f)), (_e4263 == _e4263));
let _e4274 = (_e4270 - select(0i, 1i, (_e4263 < f32(_e4270))));
let _e4275 = f32(_e4274);
let _e4279 = ((_e4257 - (_e4275 * 0.6933594f)) - (_e4275 * -2.1219444e-4f));
phi_6078_ = type_20(_e4113.member, _e4113.member_1, vec3<f32>((_e792.member_2.x * ((1f + (_e4155 * (1f + (_e4155 * (0.5f + (_e4155 * (0.16666667f + (_e4155 * (0.041666668f + (_e4155 * (0.008333334f + (_e4155 * (0.001388889f + (_e4155 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4150 + 127i)) << bitcast<u32>(23i))))), (_e792.member_2.y * ((1f + (_e4217 * (1f + (_e4217 * (0.5f + (_e4217 * (0.16666667f + (_e4217 * (0.041666668f + (_e4217 * (0.008333334f + (_e4217 * (0.001388889f + (_e4217 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4212 + 127i)) << bitcast<u32>(23i))))), (_e792.member_2.z * ((1f + (_e4279 * (1f + (_e4279 * (0.5f + (_e4279 * (0.16666667f + (_e4279 * (0.041666668f + (_e4279 * (0.008333334f + (_e4279 * (0.001388889f + (_e4279 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4274 + 127i)) << bitcast<u32>(23i)))))), _e4113.member_3, _e4113.member_4, _e4113.member_5, _e4113.member_6, _e4113.member_7, _e4113.member_8, _e4113.member_9, _e4113.member_10, _e4113.member_11, _e4113.member_12, _e4113.member_13, _e4113.member_14);
} else {
phi_6078_ = _e4093;
}
let _e4320 = phi_6078_;
let _e4322 = (_e792.member_7 * 4i);
let _e4324 = (bitcast<i32>(_e93) - 1i);
let _e4326 = select(_e4324, _e4322, (_e4322 < _e4324));
let _e4332 = global_2.member[bitcast<u32>(select(0i, _e4326, (_e4326 > 0i)))];
let _e4334 = select(_e4332, 1f, (_e792.member_7 == 16i));
let _e4336 = local_17;
let _e4337 = (_e4336 * 4i);
let _e4339 = select(_e4324, _e4337, (_e4337 < _e4324));
let _e4345 = global_2.member[bitcast<u32>(select(0i, _e4339, (_e4339 > 0i)))];
let _e4347 = local_18;
let _e4349 = select(_e4345, 1f, (_e4347 == 16i));
let _e4359 = select(1f, -1f, ((((_e4320.member_1.x * _e4017) + (_e4320.member_1.y * _e4018)) + (_e4320.member_1.z * _e4019)) > 0f));
let _e4360 = (_e4017 * _e4359);
let _e4361 = (_e4018 * _e4359);
let _e4362 = (_e4019 * _e4359);
let _e4368 = -((((_e4320.member_1.x * _e4360) + (_e4320.member_1.y * _e4361)) + (_e4320.member_1.z * _e4362)));
let _e4370 = select(0f, _e4368, (_e4368 > 0f));
let _e4371 = (_e4334 / _e4349);
let _e4373 = (_e4370 * _e4370);
let _e4376 = (1f - ((_e4371 * _e4371) * (1f - _e4373)));
let _e4377 = (_e4376 <= 0f);
let _e4385 = ((_e4371 * _e4370) - sqrt(select(0f, _e4376, (_e4376 > 0f))));
let _e4392 = (2f * _e4370);
let _e4399 = select(((_e4320.member_1.x * _e4371) + (_e4360 * _e4385)), (_e4320.member_1.x + (_e4360 * _e4392)), _e4377);
let _e4400 = select(((_e4320.member_1.y * _e4371) + (_e4361 * _e4385)), (_e4320.member_1.y + (_e4361 * _e4392)), _e4377);
let _e4401 = select(((_e4320.member_1.z * _e4371) + (_e4362 * _e4385)), (_e4320.member_1.z + (_e4362 * _e4392)), _e4377);
let _e4406 = (((_e4399 * _e4399) + (_e4400 * _e4400)) + (_e4401 * _e4401));
let _e4409 = sqrt(select(0f, _e4406, (_e4406 > 0f)));
let _e4412 = (1f / select(1e-20f, _e4409, (_e4409 > 1e-20f)));
let _e4417 = (_e4349 / _e4334);
let _e4420 = (((_e4417 * _e4417) - 1f) + _e4373);
let _e4423 = sqrt(select(0f, _e4420, (_e4420 > 0f)));
let _e4424 = (_e4423 - _e4370);
let _e4425 = (_e4423 + _e4370);
let _e4428 = (_e4424 / select(1e-6f, _e4425, (_e4425 > 1e-6f)));
let _e4432 = ((_e4370 * _e4424) + 1f);
let _e4435 = (((_e4370 * _e4425) - 1f) / select(1e-6f, _e4432, (_e4432 > 1e-6f)));
let _e4449 = global_1.member.member_1;
let _e4452 = select(0f, select(select((((0.5f * _e4428) * _e4428) * (1f + (_e4435 * _e4435))), 1f, (_e4420 <= 0f)), 0f, (_e4334 == _e4349)), ((_e4449 & 1u) != 0u));
if (_e4320.member_8 == 0f) {
let _e4467 = type_20(_e4320.member, _e4320.member_1, _e4320.member_2, _e4020, _e4320.member_4, _e4320.member_5, _e4320.member_6, _e4320.member_7, _e4320.member_8, _e4320.member_9, _e4320.member_10, _e4320.member_11, _e4320.member_12, _e4320.member_13, _e4320.member_14);
phi_6289_ = type_20(_e4467.member, _e4467.member_1, _e4467.member_2, _e4467.member_3, _e4467.member_4, _e4467.member_5, _e4467.member_6, _e4467.member_7, _e4467.member_8, _e4467.member_9, _e4467.member_10, _e4452, _e4467.member_12, _e4467.member_13, _e4467.member_14);
} else {
phi_6289_ = _e4320;
}
let _e4484 = phi_6289_;
let _e4486 = (_e4484.member_8 + 1f);
let _e4501 = type_20(_e4484.member, _e4484.member_1, _e4484.member_2, _e4484.member_3, _e4484.member_4, _e4484.member_5, _e4484.member_6, _e4484.member_7, _e4486, _e4484.member_9, _e4484.member_10, _e4484.member_11, _e4484.member_12, _e4484.member_13, _e4484.member_14);
let _e4504 = ((_e98.member_2 == 0u) && (_e4486 >= 2f));
if (_e4377 && _e4504) {
let _e4529 = (((_e4484.member_1.x * _e4017) + (_e4484.member_1.y * _e4018)) + (_e4484.member_1.z * _e4019));
let _e4533 = (_e4484.member_1.x - (_e4017 * _e4529));
let _e4534 = (_e4484.member_1.y - (_e4018 * _e4529));
let _e4535 = (_e4484.member_1.z - (_e4019 * _e4529));
let _e4540 = (((_e4533 * _e4533) + (_e4534 * _e4534)) + (_e4535 * _e4535));
let _e4543 = sqrt(select(0f, _e4540, (_e4540 > 0f)));
let _e4546 = (1f / select(1e-20f, _e4543, (_e4543 > 1e-20f)));
phi_6342_ = type_20(_e4501.member, vec3<f32>((_e4533 * _e4546), (_e4534 * _e4546), (_e4535 * _e4546)), _e4501.member_2, _e4501.member_3, _e4501.member_4, _e4501.member_5, _e4501.member_6, _e4501.member_7, _e4501.member_8, _e4501.member_9, _e4501.member_10, _e4501.member_11, _e4501.member_12, _e4501.member_13, _e4501.member_14);
} else {
phi_6342_ = type_20(_e4501.member, vec3<f32>((_e4399 * _e4412), (_e4400 * _e4412), (_e4401 * _e4412)), _e4501.member_2, _e4501.member_3, _e4501.member_4, _e4501.member_5, _e4501.member_6, _e4501.member_7, _e4501.member_8, _e4501.member_9, _e4501.member_10, _e4501.member_11, _e4501.member_12, _e4501.member_13, _e4501.member_14);
}
let _e4567 = phi_6342_;
if _e4377 {
phi_6356_ = _e4567;
} else {
let _e4568 = (1f - _e4452);
phi_6356_ = type_20(_e4567.member, _e4567.member_1, vec3<f32>((_e4567.member_2.x * _e4568), (_e4567.member_2.y * _e4568), (_e4567.member_2.z * _e4568)), _e4567.member_3, _e4567.member_4, _e4567.member_5, _e4567.member_6, _e4567.member_7, _e4567.member_8, _e4567.member_9, _e4567.member_10, _e4567.member_11, _e4567.member_12, _e4567.member_13, _e4567.member_14);
}
let _e4595 = phi_6356_;
let _e4602 = global_1.member.member_17.member.member;
let _e4616 = ((((_e4602.member.member * _e4595.member.x) + (_e4602.member.member_1 * _e4595.member.y)) + (_e4602.member.member_2 * _e4595.member.z)) + _e4602.member_1);
let _e4625 = -((((_e4602.member.member * _e4595.member_1.x) + (_e4602.member.member_1 * _e4595.member_1.y)) + (_e4602.member.member_2 * _e4595.member_1.z)));
let _e4627 = (_e4625 > 1e-9f);
let _e4631 = ((_e4616 / select(1e-9f, _e4625, _e4627)) - 0.015625f);
let _e4634 = select(1e30f, select(0f, _e4631, (_e4631 > 0f)), ((_e4616 > 0f) && _e4627));
let _e4639 = global_1.member.member_17.member_1.member;
let _e4650 = ((((_e4639.member.member * _e4595.member.x) + (_e4639.member.member_1 * _e4595.member.y)) + (_e4639.member.member_2 * _e4595.member.z)) + _e4639.member_1);
let _e4656 = -((((_e4639.member.member * _e4595.member_1.x) + (_e4639.member.member_1 * _e4595.member_1.y)) + (_e4639.member.member_2 * _e4595.member_1.z)));
let _e4658 = (_e4656 > 1e-9f);
let _e4662 = ((_e4650 / select(1e-9f, _e4656, _e4658)) - 0.015625f);
let _e4665 = select(1e30f, select(0f, _e4662, (_e4662 > 0f)), ((_e4650 > 0f) && _e4658));
let _e4669 = (_e4665 < _e4634);
let _e4671 = select(select(-2i, -3i, _e4669), -1i, ((_e4634 >= 1e30f) && (_e4665 >= 1e30f)));
let _e4672 = select(_e4634, _e4665, _e4669);
let _e4687 = type_20(_e4595.member, _e4595.member_1, _e4595.member_2, _e4595.member_3, _e4595.member_4, _e4595.member_5, _e4595.member_6, _e4595.member_7, _e4595.member_8, _e4595.member_9, _e4595.member_10, _e4595.member_11, 0i, _e4595.member_13, _e4595.member_14);
let _e4702 = type_20(_e4687.member, _e4687.member_1, _e4687.member_2, _e4687.member_3, _e4687.member_4, _e4687.member_5, _e4687.member_6, _e4687.member_7, _e4687.member_8, _e4687.member_9, _e4687.member_10, _e4687.member_11, _e4687.member_12, _e4671, _e4687.member_14);
let _e4717 = type_20(_e4702.member, _e4702.member_1, _e4702.member_2, _e4702.member_3, _e4702.member_4, _e4702.member_5, _e4702.member_6, _e4702.member_7, _e4702.member_8, _e4702.member_9, _e4702.member_10, _e4702.member_11, _e4702.member_12, _e4702.member_13, _e4672);
let _e4719 = local_19;
let _e4722 = ((_e4449 & 2u) != 0u);
if (_e4504 && !(_e4722)) {
if (_e4671 == -1i) {
phi_6781_ = type_20(_e4717.member, _e4717.member_1, _e4717.member_2, _e4717.member_3, _e4717.member_4, _e4717.member_5, 1f, _e4717.member_7, _e4717.member_8, _e4717.member_9, _e4717.member_10, _e4717.member_11, _e4717.member_12, _e4717.member_13, _e4717.member_14);
} else {
let _e4798 = type_20(vec3<f32>((_e4595.member.x + (_e4595.member_1.x * _e4672)), (_e4595.member.y + (_e4595.member_1.y * _e4672)), (_e4595.member.z + (_e4595.member_1.z * _e4672))), _e4717.member_1, _e4717.member_2, _e4717.member_3, _e4717.member_4, _e4717.member_5, _e4717.member_6, _e4717.member_7, _e4717.member_8, _e4717.member_9, _e4717.member_10, _e4717.member_11, _e4717.member_12, _e4717.member_13, _e4717.member_14);
let _e4814 = type_20(_e4798.member, _e4798.member_1, _e4798.member_2, _e4798.member_3, _e4798.member_4, _e4798.member_5, _e4798.member_6, _e4798.member_7, _e4798.member_8, _e4798.member_9, _e4798.member_10, _e4798.member_11, _e4798.member_12, _e4798.member_13, (_e4672 - _e4672));
let _e4834 = type_20(_e4814.member, _e4814.member_1, _e4814.member_2, _e4814.member_3, _e4814.member_4, _e4814.member_5, _e4814.member_6, _e4814.member_7, _e4814.member_8, _e4814.member_9, (_e4595.member_10 + select(0f, _e4672, (_e4595.member_8 == 0f))), _e4814.member_11, _e4814.member_12, _e4814.member_13, _e4814.member_14);
phi_6781_ = type_20(_e4834.member, _e4834.member_1, _e4834.member_2, _e4834.member_3, _e4834.member_4, _e4834.member_5, 3f, _e4834.member_7, _e4834.member_8, _e4834.member_9, _e4834.member_10, _e4834.member_11, _e4834.member_12, _e4834.member_13, _e4834.member_14);
}
let _e4866 = phi_6781_;
phi_6802_ = _e4866;
} else {
let _e4729 = global_1.member.member_5;
if ((!(_e4504) && (_e4595.member_8 >= f32(bitcast<i32>(_e4729)))) && (select(_e4719, _e792.member_7, _e4377) != 16i)) {
phi_6801_ = type_20(_e4717.member, _e4717.member_1, _e4717.member_2, _e4717.member_3, _e4717.member_4, _e4717.member_5, 2f, _e4717.member_7, _e4717.member_8, _e4717.member_9, _e4717.member_10, _e4717.member_11, _e4717.member_12, _e4717.member_13, _e4717.member_14);
} else {
if _e4722 {
phi_6800_ = type_20(_e4717.member, _e4717.member_1, _e4717.member_2, _e4717.member_3, _e4717.member_4, _e4717.member_5, 4f, _e4717.member_7, _e4717.member_8, _e4717.member_9, _e4717.member_10, _e4717.member_11, _e4717.member_12, _e4717.member_13, _e4717.member_14);
} else {
phi_6800_ = _e4717;
}
let _e4752 = phi_6800_;
phi_6801_ = _e4752;
}
let _e4769 = phi_6801_;
phi_6802_ = _e4769;
}
let _e4868 = phi_6802_;
let _e4871 = local_20;
let _e4887 = type_20(_e4868.member, _e4868.member_1, _e4868.member_2, _e4868.member_3, _e4868.member_4, _e4868.member_5, _e4868.member_6, select(_e792.member_7, _e4871, !(_e4377)), _e4868.member_8, _e4868.member_9, _e4868.member_10, _e4868.member_11, _e4868.member_12, _e4868.member_13, _e4868.member_14);
let _e4902 = type_20(_e4887.member, _e4887.member_1, _e4887.member_2, _e4887.member_3, _e4020, _e4887.member_5, _e4887.member_6, _e4887.member_7, _e4887.member_8, _e4887.member_9, _e4887.member_10, _e4887.member_11, _e4887.member_12, _e4887.member_13, _e4887.member_14);
phi_6811_ = type_20(_e4902.member, _e4902.member_1, _e4902.member_2, _e4902.member_3, _e4902.member_4, 0f, _e4902.member_6, _e4902.member_7, _e4902.member_8, _e4902.member_9, _e4902.member_10, _e4902.member_11, _e4902.member_12, _e4902.member_13, _e4902.member_14);
}
let _e4919 = phi_6811_;
phi_6812_ = _e4919;
phi_6813_ = _e4046;
}
let _e4921 = phi_6812_;
let _e4923 = phi_6813_;
if (_e4923 && _e1002) {
let _e5393 = type_20(vec3<f32>((_e4921.member.x + (_e4921.member_1.x * _e4921.member_14)), (_e4921.member.y + (_e4921.member_1.y * _e4921.member_14)), (_e4921.member.z + (_e4921.member_1.z * _e4921.member_14))), _e4921.member_1, _e4921.member_2, _e4921.member_3, _e4921.member_4, _e4921.member_5, _e4921.member_6, _e4921.member_7, _e4921.member_8, _e4921.member_9, _e4921.member_10, _e4921.member_11, _e4921.member_12, _e4921.member_13, _e4921.member_14);
let _e5410 = type_20(_e5393.member, _e5393.member_1, _e5393.member_2, _e5393.member_3, _e5393.member_4, (_e4921.member_5 + _e4921.member_14), _e5393.member_6, _e5393.member_7, _e5393.member_8, _e5393.member_9, _e5393.member_10, _e5393.member_11, _e5393.member_12, _e5393.member_13, _e5393.member_14);
let _e5426 = type_20(_e5410.member, _e5410.member_1, _e5410.member_2, _e5410.member_3, _e5410.member_4, _e5410.member_5, _e5410.member_6, _e5410.member_7, _e5410.member_8, _e5410.member_9, _e5410.member_10, _e5410.member_11, _e5410.member_12, _e5410.member_13, (_e4921.member_14 - _e4921.member_14));
let _e5446 = type_20(_e5426.member, _e5426.member_1, _e5426.member_2, _e5426.member_3, _e5426.member_4, _e5426.member_5, _e5426.member_6, _e5426.member_7, _e5426.member_8, _e5426.member_9, (_e4921.member_10 + select(0f, _e4921.member_14, (_e4921.member_8 == 0f))), _e5426.member_11, _e5426.member_12, _e5426.member_13, _e5426.member_14);
if (_e792.member_7 != 16i) {
let _e5464 = type_20(_e5446.member, _e5446.member_1, _e5446.member_2, _e5446.member_3, _e5446.member_4, _e5446.member_5, _e5446.member_6, _e5446.member_7, _e5446.member_8, (_e4921.member_9 + _e4921.member_14), _e5446.member_10, _e5446.member_11, _e5446.member_12, _e5446.member_13, _e5446.member_14);
let _e5465 = (_e792.member_7 * 4i);
let _e5466 = (_e5465 + 1i);
let _e5468 = (bitcast<i32>(_e93) - 1i);
let _e5470 = select(_e5468, _e5466, (_e5466 < _e5468));
let _e5476 = global_2.member[bitcast<u32>(select(0i, _e5470, (_e5470 > 0i)))];
let _e5478 = -((_e5476 * _e4921.member_14));
let _e5480 = select(-87f, _e5478, (_e5478 > -87f));
let _e5482 = select(88f, _e5480, (_e5480 < 88f));
let _e5484 = ((_e5482 * 1.442695f) + 0.5f);
let _e5486 = select(-127f, _e5484, (_e5484 > -127f));
let _e5488 = select(128f, _e5486, (_e5486 < 128f));
let _e5495 = select(0i, select(select(i32(_e5488), i32(-2147483648), (_e5488 < -2147483600f)), 2147483647i, (_e5488 > 2147483500f)), (_e5488 == _e5488));
let _e5499 = (_e5495 - select(0i, 1i, (_e5488 < f32(_e5495))));
let _e5500 = f32(_e5499);
let _e5504 = ((_e5482 - (_e5500 * 0.6933594f)) - (_e5500 * -2.1219444e-4f));
let _e5528 = (_e5465 + 2i);
let _e5530 = select(_e5468, _e5528, (_e5528 < _e5468));
let _e5536 = global_2.member[bitcast<u32>(select(0i, _e5530, (_e5530 > 0i)))];
let _e5538 = -((_e5536 * _e4921.member_14));
let _e5540 = select(-87f, _e5538, (_e5538 > -87f));
let _e5542 = select(88f, _e5540, (_e5540 < 88f));
let _e5544 = ((_e5542 * 1.442695f) + 0.5f);
let _e5546 = select(-127f, _e5544, (_e5544 > -127f));
let _e5548 = select(128f, _e5546, (_e5546 < 128f));
let _e5555 = select(0i, select(select(i32(_e5548), i32(-2147483648), (_e5548 < -2147483600f)), 2147483647i, (_e5548 > 2147483500f)), (_e5548 == _e5548));
let _e5559 = (_e5555 - select(0i, 1i, (_e5548 < f32(_e5555))));
let _e5560 = f32(_e5559);
let _e5564 = ((_e5542 - (_e5560 * 0.6933594f)) - (_e5560 * -2.1219444e-4f));
let _e5588 = (_e5465 + 3i);
let _e5590 = select(_e5468, _e5588, (_e5588 < _e5468));
let _e5596 = global_2.member[bitcast<u32>(select(0i, _e5590, (_e5590 > 0i)))];
let _e5598 = -((_e5596 * _e4921.member_14));
let _e5600 = select(-87f, _e5598, (_e5598 > -87f));
let _e5602 = select(88f, _e5600, (_e5600 < 88f));
let _e5604 = ((_e5602 * 1.442695f) + 0.5f);
let _e5606 = select(-127f, _e5604, (_e5604 > -127f));
let _e5608 = select(128f, _e5606, (_e5606 < 128f));
let _e5615 = select(0i, select(select(i32(_e5608), i32(-2147483648), (_e5608 < -2147483600f)), 2147483647i, (_e5608 > 2147483500f)), (_e5608 == _e5608));
let _e5619 = (_e5615 - select(0i, 1i, (_e5608 < f32(_e5615))));
let _e5620 = f32(_e5619);
let _e5624 = ((_e5602 - (_e5620 * 0.6933594f)) - (_e5620 * -2.1219444e-4f));
phi_7103_ = type_20(_e5464.member, _e5464.member_1, vec3<f32>((_e4921.member_2.x * ((1f + (_e5504 * (1f + (_e5504 * (0.5f + (_e5504 * (0.16666667f + (_e5504 * (0.041666668f + (_e5504 * (0.008333334f + (_e5504 * (0.001388889f + (_e5504 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5499 + 127i)) << bitcast<u32>(23i))))), (_e4921.member_2.y * ((1f + (_e5564 * (1f + (_e5564 * (0.5f + (_e5564 * (0.16666667f + (_e5564 * (0.041666668f + (_e5564 * (0.008333334f + (_e5564 * (0.001388889f + (_e5564 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5559 + 127i)) << bitcast<u32>(23i))))), (_e4921.member_2.z * ((1f + (_e5624 * (1f + (_e5624 * (0.5f + (_e5624 * (0.16666667f + (_e5624 * (0.041666668f + (_e5624 * (0.008333334f + (_e5624 * (0.001388889f + (_e5624 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5619 + 127i)) << bitcast<u32>(23i)))))), _e5464.member_3, _e5464.member_4, _e5464.member_5, _e5464.member_6, _e5464.member_7, _e5464.member_8, _e5464.member_9, _e5464.member_10, _e5464.member_11, _e5464.member_12, _e5464.member_13, _e5464.member_14);
} else {
phi_7103_ = _e5446;
}
let _e5665 = phi_7103_;
phi_7697_ = type_20(_e5665.member, _e5665.member_1, _e5665.member_2, _e5665.member_3, _e5665.member_4, _e5665.member_5, 3f, _e5665.member_7, _e5665.member_8, _e5665.member_9, _e5665.member_10, _e5665.member_11, _e5665.member_12, _e5665.member_13, _e5665.member_14);
} else {
if _e4923 {
let _e4956 = type_20(vec3<f32>((_e4921.member.x + (_e4921.member_1.x * _e1003)), (_e4921.member.y + (_e4921.member_1.y * _e1003)), (_e4921.member.z + (_e4921.member_1.z * _e1003))), _e4921.member_1, _e4921.member_2, _e4921.member_3, _e4921.member_4, _e4921.member_5, _e4921.member_6, _e4921.member_7, _e4921.member_8, _e4921.member_9, _e4921.member_10, _e4921.member_11, _e4921.member_12, _e4921.member_13, _e4921.member_14);
let _e4973 = type_20(_e4956.member, _e4956.member_1, _e4956.member_2, _e4956.member_3, _e4956.member_4, (_e4921.member_5 + _e1003), _e4956.member_6, _e4956.member_7, _e4956.member_8, _e4956.member_9, _e4956.member_10, _e4956.member_11, _e4956.member_12, _e4956.member_13, _e4956.member_14);
let _e4990 = type_20(_e4973.member, _e4973.member_1, _e4973.member_2, _e4973.member_3, _e4973.member_4, _e4973.member_5, _e4973.member_6, _e4973.member_7, _e4973.member_8, _e4973.member_9, _e4973.member_10, _e4973.member_11, _e4973.member_12, _e4973.member_13, (_e4921.member_14 - _e1003));
let _e5010 = type_20(_e4990.member, _e4990.member_1, _e4990.member_2, _e4990.member_3, _e4990.member_4, _e4990.member_5, _e4990.member_6, _e4990.member_7, _e4990.member_8, _e4990.member_9, (_e4921.member_10 + select(0f, _e1003, (_e4921.member_8 == 0f))), _e4990.member_11, _e4990.member_12, _e4990.member_13, _e4990.member_14);
if (_e792.member_7 != 16i) {
let _e5028 = type_20(_e5010.member, _e5010.member_1, _e5010.member_2, _e5010.member_3, _e5010.member_4, _e5010.member_5, _e5010.member_6, _e5010.member_7, _e5010.member_8, (_e4921.member_9 + _e1003), _e5010.member_10, _e5010.member_11, _e5010.member_12, _e5010.member_13, _e5010.member_14);
let _e5029 = (_e792.member_7 * 4i);
let _e5030 = (_e5029 + 1i);
let _e5032 = (bitcast<i32>(_e93) - 1i);
let _e5034 = select(_e5032, _e5030, (_e5030 < _e5032));
let _e5040 = global_2.member[bitcast<u32>(select(0i, _e5034, (_e5034 > 0i)))];
let _e5042 = -((_e5040 * _e1003));
let _e5044 = select(-87f, _e5042, (_e5042 > -87f));
let _e5046 = select(88f, _e5044, (_e5044 < 88f));
let _e5048 = ((_e5046 * 1.442695f) + 0.5f);
let _e5050 = select(-127f, _e5048, (_e5048 > -127f));
let _e5052 = select(128f, _e5050, (_e5050 < 128f));
let _e5059 = select(0i, select(select(i32(_e5052), i32(-2147483648), (_e5052 < -2147483600f)), 2147483647i, (_e5052 > 2147483500f)), (_e5052 == _e5052));
let _e5063 = (_e5059 - select(0i, 1i, (_e5052 < f32(_e5059))));
let _e5064 = f32(_e5063);
let _e5068 = ((_e5046 - (_e5064 * 0.6933594f)) - (_e5064 * -2.1219444e-4f));
let _e5092 = (_e5029 + 2i);
let _e5094 = select(_e5032, _e5092, (_e5092 < _e5032));
let _e5100 = global_2.member[bitcast<u32>(select(0i, _e5094, (_e5094 > 0i)))];
let _e5102 = -((_e5100 * _e1003));
let _e5104 = select(-87f, _e5102, (_e5102 > -87f));
let _e5106 = select(88f, _e5104, (_e5104 < 88f));
let _e5108 = ((_e5106 * 1.442695f) + 0.5f);
let _e5110 = select(-127f, _e5108, (_e5108 > -127f));
let _e5112 = select(128f, _e5110, (_e5110 < 128f));
let _e5119 = select(0i, select(select(i32(_e5112), i32(-2147483648), (_e5112 < -2147483600f)), 2147483647i, (_e5112 > 2147483500f)), (_e5112 == _e5112));
let _e5123 = (_e5119 - select(0i, 1i, (_e5112 < f32(_e5119))));
let _e5124 = f32(_e5123);
let _e5128 = ((_e5106 - (_e5124 * 0.6933594f)) - (_e5124 * -2.1219444e-4f));
let _e5152 = (_e5029 + 3i);
let _e5154 = select(_e5032, _e5152, (_e5152 < _e5032));
let _e5160 = global_2.member[bitcast<u32>(select(0i, _e5154, (_e5154 > 0i)))];
let _e5162 = -((_e5160 * _e1003));
let _e5164 = select(-87f, _e5162, (_e5162 > -87f));
let _e5166 = select(88f, _e5164, (_e5164 < 88f));
let _e5168 = ((_e5166 * 1.442695f) + 0.5f);
let _e5170 = select(-127f, _e5168, (_e5168 > -127f));
let _e5172 = select(128f, _e5170, (_e5170 < 128f));
let _e5179 = select(0i, select(select(i32(_e5172), i32(-2147483648), (_e5172 < -2147483600f)), 2147483647i, (_e5172 > 2147483500f)), (_e5172 == _e5172));
let _e5183 = (_e5179 - select(0i, 1i, (_e5172 < f32(_e5179))));
let _e5184 = f32(_e5183);
let _e5188 = ((_e5166 - (_e5184 * 0.6933594f)) - (_e5184 * -2.1219444e-4f));
phi_7392_ = type_20(_e5028.member, _e5028.member_1, vec3<f32>((_e4921.member_2.x * ((1f + (_e5068 * (1f + (_e5068 * (0.5f + (_e5068 * (0.16666667f + (_e5068 * (0.041666668f + (_e5068 * (0.008333334f + (_e5068 * (0.001388889f + (_e5068 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5063 + 127i)) << bitcast<u32>(23i))))), (_e4921.member_2.y * ((1f + (_e5128 * (1f + (_e5128 * (0.5f + (_e5128 * (0.16666667f + (_e5128 * (0.041666668f + (_e5128 * (0.008333334f + (_e5128 * (0.001388889f + (_e5128 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5123 + 127i)) << bitcast<u32>(23i))))), (_e4921.member_2.z * ((1f + (_e5188 * (1f + (_e5188 * (0.5f + (_e5188 * (0.16666667f + (_e5188 * (0.041666668f + (_e5188 * (0.008333334f + (_e5188 * (0.001388889f + (_e5188 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5183 + 127i)) << bitcast<u32>(23i)))))), _e5028.member_3, _e5028.member_4, _e5028.member_5, _e5028.member_6, _e5028.member_7, _e5028.member_8, _e5028.member_9, _e5028.member_10, _e5028.member_11, _e5028.member_12, _e5028.member_13, _e5028.member_14);
} else {
phi_7392_ = _e5010;
}
let _e5229 = phi_7392_;
let _e5232 = local_21;
if (((_e853 <= 0f) && (_e5232 == 16i)) && (_e792.member_7 == 16i)) {
if (_e5229.member_13 == -1i) {
phi_7694_ = type_20(_e5229.member, _e5229.member_1, _e5229.member_2, _e5229.member_3, _e5229.member_4, _e5229.member_5, 1f, _e5229.member_7, _e5229.member_8, _e5229.member_9, _e5229.member_10, _e5229.member_11, _e5229.member_12, _e5229.member_13, _e5229.member_14);
} else {
let _e5271 = type_20(vec3<f32>((_e5229.member.x + (_e5229.member_1.x * _e5229.member_14)), (_e5229.member.y + (_e5229.member_1.y * _e5229.member_14)), (_e5229.member.z + (_e5229.member_1.z * _e5229.member_14))), _e5229.member_1, _e5229.member_2, _e5229.member_3, _e5229.member_4, _e5229.member_5, _e5229.member_6, _e5229.member_7, _e5229.member_8, _e5229.member_9, _e5229.member_10, _e5229.member_11, _e5229.member_12, _e5229.member_13, _e5229.member_14);
let _e5288 = type_20(_e5271.member, _e5271.member_1, _e5271.member_2, _e5271.member_3, _e5271.member_4, (_e5229.member_5 + _e5229.member_14), _e5271.member_6, _e5271.member_7, _e5271.member_8, _e5271.member_9, _e5271.member_10, _e5271.member_11, _e5271.member_12, _e5271.member_13, _e5271.member_14);
let _e5304 = type_20(_e5288.member, _e5288.member_1, _e5288.member_2, _e5288.member_3, _e5288.member_4, _e5288.member_5, _e5288.member_6, _e5288.member_7, _e5288.member_8, _e5288.member_9, _e5288.member_10, _e5288.member_11, _e5288.member_12, _e5288.member_13, (_e5229.member_14 - _e5229.member_14));
let _e5324 = type_20(_e5304.member, _e5304.member_1, _e5304.member_2, _e5304.member_3, _e5304.member_4, _e5304.member_5, _e5304.member_6, _e5304.member_7, _e5304.member_8, _e5304.member_9, (_e5229.member_10 + select(0f, _e5229.member_14, (_e5229.member_8 == 0f))), _e5304.member_11, _e5304.member_12, _e5304.member_13, _e5304.member_14);
phi_7694_ = type_20(_e5324.member, _e5324.member_1, _e5324.member_2, _e5324.member_3, _e5324.member_4, _e5324.member_5, 3f, _e5324.member_7, _e5324.member_8, _e5324.member_9, _e5324.member_10, _e5324.member_11, _e5324.member_12, _e5324.member_13, _e5324.member_14);
}
let _e5356 = phi_7694_;
phi_7695_ = _e5356;
} else {
phi_7695_ = _e5229;
}
let _e5358 = phi_7695_;
phi_7696_ = _e5358;
} else {
phi_7696_ = _e4921;
}
let _e5360 = phi_7696_;
phi_7697_ = _e5360;
}
let _e5682 = phi_7697_;
phi_1317_ = _e5682;
phi_1320_ = (_e794 + 1i);
} else {
phi_1317_ = type_20();
phi_1320_ = i32();
}
let _e5684 = phi_1317_;
let _e5686 = phi_1320_;
continue;
continuing {
phi_1316_ = _e5684;
phi_1319_ = _e5686;
break if !(_e798);
}
}
let _e5689 = local_22;
let _e5693 = local_23;
let _e5697 = local_24;
let _e5701 = local_25;
let _e5705 = local_26;
let _e5709 = local_27;
let _e5713 = local_28;
let _e5717 = local_29;
let _e5721 = local_30;
let _e5725 = local_31;
let _e5729 = local_32;
let _e5733 = local_33;
let _e5737 = local_34;
let _e5741 = local_35;
let _e5745 = local_36;
let _e5749 = local_37;
let _e5752 = local_38;
let _e5756 = local_39;
let _e5759 = local_40;
let _e5762 = local_41;
let _e5765 = local_42;
let _e5768 = local_43;
let _e5772 = local_44;
let _e5776 = local_45;
global_3.member[_e107] = _e5689.member.x;
global_3.member[_e119] = _e5693.member.y;
global_3.member[_e130] = _e5697.member.z;
global_3.member[_e141] = _e5701.member_1.x;
global_3.member[_e152] = _e5705.member_1.y;
global_3.member[_e163] = _e5709.member_1.z;
global_3.member[_e174] = _e5713.member_2.x;
global_3.member[_e185] = _e5717.member_2.y;
global_3.member[_e196] = _e5721.member_2.z;
global_3.member[_e207] = _e5725.member_3.x;
global_3.member[_e218] = _e5729.member_3.y;
global_3.member[_e229] = _e5733.member_3.z;
global_3.member[_e240] = _e5737.member_4.x;
global_3.member[_e251] = _e5741.member_4.y;
global_3.member[_e262] = _e5745.member_4.z;
global_3.member[_e273] = _e5749.member_5;
let _e5813 = local_46;
global_3.member[_e284] = _e5813;
global_3.member[_e295] = f32(_e5752.member_7);
global_3.member[_e306] = _e5756.member_8;
global_3.member[_e317] = _e5759.member_9;
global_3.member[_e328] = _e5762.member_10;
global_3.member[_e339] = _e5765.member_11;
global_3.member[_e350] = f32(_e5768.member_12);
global_3.member[_e361] = f32(_e5772.member_13);
global_3.member[_e372] = _e5776.member_14;
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
